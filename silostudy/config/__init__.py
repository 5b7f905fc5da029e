"""What users ask for: YAML files read into frozen models, every key described and with its unit."""
