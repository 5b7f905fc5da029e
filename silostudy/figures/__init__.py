"""Pictures and tables drawn from a cube: one file each, all of them listed in tables/outputs.csv."""
