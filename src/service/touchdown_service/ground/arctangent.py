"""Angle of a vector by + - * / and a polynomial: the same bits as src/dynamics/terrain/arctangent.ts (ORDER, Heightmap)."""

C1 = -0.3333333333332844
C2 = 0.19999999998855109
C3 = -0.14285714180976392
C4 = 0.11111106180452865
C5 = -0.0909077307473686
C6 = 0.07689953495298942
C7 = -0.06640233921673451
C8 = 0.056883491809884175
C9 = -0.04348052083340628
C10 = 0.021135371536498415

PI = 3.141592653589793
HALF_PI = 1.5707963267948966
QUARTER_PI = 0.7853981633974483
# tan(pi / 8)
SPLIT = 0.41421356237309503


def angle_of(y: float, x: float) -> float:
    """Angle from the x axis to (x, y), rad, -pi to pi; 0 for the zero vector."""
    ax = -x if x < 0 else x
    ay = -y if y < 0 else y
    larger = ay if ay > ax else ax
    smaller = ax if ay > ax else ay
    if larger == 0:
        return 0.0
    is_steep = smaller > SPLIT * larger
    reduced = (smaller - larger) / (smaller + larger) if is_steep else smaller / larger
    u = reduced * reduced
    high = C6 + u * (C7 + u * (C8 + u * (C9 + u * C10)))
    low = C1 + u * (C2 + u * (C3 + u * (C4 + u * (C5 + u * high))))
    small = reduced + reduced * (u * low)
    octant = QUARTER_PI + small if is_steep else small
    quadrant = HALF_PI - octant if ay > ax else octant
    half = PI - quadrant if x < 0 else quadrant
    return -half if y < 0 else half
