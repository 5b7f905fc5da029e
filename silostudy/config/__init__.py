"""Configuration: YAML files read into frozen models, every key described and with its unit."""
