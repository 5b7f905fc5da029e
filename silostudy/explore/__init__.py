"""A cube in the browser: choose a quantity, slice its axes, overlay methods, see where a point comes from, export."""
