"""Effective mass of a silo's contents in an earthquake: beam, records, response, likeness, identification, code rules."""
