"""What the service leaves out for speed changes nothing: look-ups far above the ground, redis-py's own packing."""

import unittest
from array import array
from math import inf, sqrt
from random import Random

from harness import lander
from redis._parsers.encoders import Encoder
from redis.connection import PythonRespSerializer
from redis.exceptions import DataError
from test_simulation import galaxy_with, run

from touchdown_service.ground.heightmap import Heightmap, heightmap_terrain
from touchdown_service.ground.terrain import HIGHEST, RELIEFS, TERRAINS, flat
from touchdown_service.storage.packing import CommandPacker


def drawn_directions(seed: int, count: int) -> list[list[float]]:
    draw = Random(seed)
    drawn = ([draw.gauss(0, 1) for _ in range(3)] for _ in range(count))
    return [[part / sqrt(sum(c * c for c in given)) for part in given] for given in drawn]


class HighestGround(unittest.TestCase):
    def test_no_ground_of_a_terrain_is_above_its_highest(self) -> None:
        for terrain, height in TERRAINS.items():
            for body in (*RELIEFS, "a body without a relief"):
                reached = max(height(body, *direction) for direction in drawn_directions(1, 4000))
                self.assertLessEqual(reached, HIGHEST[terrain](body), (terrain, body))

    def test_no_look_up_in_a_heightmap_is_above_its_highest(self) -> None:
        # A checkerboard of the extremes, each field two samples wide: Catmull-Rom overshoots most between two equal ones.
        steps = array("h", [32767 if (row // 2 + column // 2) % 2 else -32768 for row in range(8) for column in range(16)])
        for samples in (steps, array("h", [-900] * 128), array("h", [0] * 128)):
            for interpolation in ("bilinear", "bicubic"):
                for scale in (0.5, -2.0):
                    grid = Heightmap(samples, 16, 8, scale, 1737400.0, 1737000.0, interpolation)
                    height = heightmap_terrain({"Luna": grid}, flat)
                    reached = max(height("Luna", *direction) for direction in drawn_directions(2, 500))
                    self.assertLessEqual(reached, grid.highest)

    def test_a_descent_has_the_same_bits_without_the_look_ups_above_it(self) -> None:
        landings = []
        for highest in (None, inf):
            galaxy = galaxy_with(lander(direction=[0.3, 0.8, -0.5], height=1500, velocity=[40, 0, -20]))
            ship, world = galaxy.ships["s1"], galaxy.world
            looked_up = []
            height = world.terrain_height
            world.terrain_height = lambda *place: looked_up.append(place) or height(*place)
            if highest is not None:
                ship.body.highest_ground = highest
            events = [(e.tick, e.substep, e.type, e.impact_speed) for e in run(galaxy, 40).events]
            landings.append((events, ship.position, ship.velocity, ship.attitude, len(looked_up)))
        with_shortcut, without = landings
        self.assertEqual(with_shortcut[:4], without[:4])
        self.assertEqual(with_shortcut[0][-1][2], "ship.destroyed")
        self.assertLess(with_shortcut[4], 0.9 * without[4])


class Packing(unittest.TestCase):
    def test_bytes_are_those_of_redis_py(self) -> None:
        theirs = PythonRespSerializer(6000, Encoder("utf-8", "replace", True).encode)
        for command in (
            ("HSET", "ship:s1", "position", "[1.5, -2.0, 3e-07]", "name", ""),
            ("HSET", "ship:s1", "name", "Æthelflæd 月", "player_id", "\ud800"),
            ("CONFIG GET", "appendonly"),
            (b"CLIENT SETINFO", b"LIB-NAME", b"redis-py \xff"),
            ("SET", "touchdown:lease", "token", "px", 3000, 0.1, -1e-320),
            ("SET", "touchdown:bodies", "x" * 100_000),
            ("PING",),
        ):
            self.assertEqual(b"".join(CommandPacker().pack(*command)), b"".join(theirs.pack(*command)), command)

    def test_what_redis_has_no_form_for_is_refused(self) -> None:
        for value in (None, True, [1.0], {}):
            with self.assertRaises(DataError):
                CommandPacker().pack("SET", "game:paused", value)


if __name__ == "__main__":
    unittest.main()
