"""Step 5 in the air: velocity Verlet under gravity and thrust (ORDER, step 5)."""

from ..models import Ship
from .surface import Place, place_of
from .vectors import Vec3


def fly(ship: Ship, place: Place, thrust: Vec3, mass: float, dt: float) -> Place:
    """Returns the position quantities at the substep's end."""
    nx, ny, nz, _, g = place
    half = 0.5 * dt
    half_squared = half * dt
    per_mass = 1 / mass
    px = thrust[0] * per_mass
    py = thrust[1] * per_mass
    pz = thrust[2] * per_mass
    ax = px - g * nx
    ay = py - g * ny
    az = pz - g * nz
    ux, uy, uz = ship.velocity
    x, y, z = ship.position
    ship.position = position = (
        x + (ux * dt + ax * half_squared),
        y + (uy * dt + ay * half_squared),
        z + (uz * dt + az * half_squared),
    )
    end = place_of(position, ship.body.mu)
    nx, ny, nz, _, g = end
    ship.velocity = (
        ux + (ax + (px - g * nx)) * half,
        uy + (ay + (py - g * ny)) * half,
        uz + (az + (pz - g * nz)) * half,
    )
    return end
