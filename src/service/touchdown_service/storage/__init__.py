"""Ships, bodies, clock and frames as Redis holds them."""
