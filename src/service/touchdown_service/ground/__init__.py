"""Ground heights: named terrains, their noise, and heightmaps in the game's format."""
