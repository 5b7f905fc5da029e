"""Published values as CSV, each row with source and locator, read into SI units."""
