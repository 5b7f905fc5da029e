"""Space: what of contacts, motions and walls belongs to three dimensions."""
