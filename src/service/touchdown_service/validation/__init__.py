"""Checks of all input: a refusal names the field."""
