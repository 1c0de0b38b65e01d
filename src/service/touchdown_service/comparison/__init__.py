"""Trajectories and heights, written for comparison with other implementations."""
