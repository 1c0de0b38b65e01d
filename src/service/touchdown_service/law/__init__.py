"""The passes of one substep, in the order of contact.py, and their vectors."""
