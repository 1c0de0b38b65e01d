"""The running service: schedule, lease, incoming commands, and the world between two ticks."""
