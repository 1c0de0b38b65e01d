import { addLegs } from './legs';
import { createParts, FINISHES, type Parts } from './parts';
import { addStrut, ball, bell, box, foilPrism, ring, tube, turned } from './shapes';
import { type ShipModel, type Stance, thrusterClusters } from '../shipModel';

/** Foil-wrapped stage on four legs, tanks around its waist, cabin on top. Sizes are shares of the height over the feet. */
export function buildLander(stance: Stance): ShipModel {
  const parts = createParts();
  const s = stance.h / 4.56;
  const m = (share: number) => share * s;
  parts.add(foilPrism(m(1.95), m(1.6), 8, 0.035), FINISHES.foil, { at: [0, 0, m(-1.4)] });
  parts.add(tube(m(2), m(2), m(0.1), 8), FINISHES.grey, { at: [0, 0, m(-0.57)], spin: Math.PI / 8 });
  parts.add(tube(m(1.75), m(2), m(0.14), 8), FINISHES.dark, { at: [0, 0, m(-2.26)], spin: Math.PI / 8 });
  parts.add(bell(m(0.82), m(1.35)), FINISHES.bell, { at: [0, 0, m(-2.3)] });
  parts.add(ring(m(0.82), m(0.035)), FINISHES.silver, { at: [0, 0, m(-3.65)] });
  addTanks(parts, m);
  addCabin(parts, m);
  addMast(parts, m);
  addBooms(parts, stance.legRadius, m);
  addLegs(parts, stance, {
    hip: [m(1.86), m(-0.72)],
    brace: [m(1.8), m(-2.1)],
    spread: 0.5,
    thickness: m(0.13),
    padRadius: m(0.52),
    finish: FINISHES.foil,
  });
  addLadder(parts, stance, m);
  return {
    ...parts.build(),
    engines: [{ at: [0, 0, m(-3.6)], radius: m(0.72) }],
    thrusters: thrusterClusters(stance.legRadius - m(0.1), m(1.55), Math.PI / 4),
  };
}

type Scale = (share: number) => number;

function addTanks(parts: Parts, m: Scale): void {
  for (let n = 0; n < 4; n++) {
    const angle = (n * Math.PI) / 2;
    const [x, y] = [Math.cos(angle) * m(1.5), Math.sin(angle) * m(1.5)];
    parts.add(ball(m(0.78), 20), n % 2 === 0 ? FINISHES.white : FINISHES.silver, { at: [x, y, m(0.32)] });
    parts.add(ring(m(0.79), m(0.04)), FINISHES.grey, { at: [x, y, m(0.32)] });
    addStrut(parts, FINISHES.grey, { from: [x, y, m(-0.6)], to: [x, y, m(-0.4)], radius: m(0.3) });
  }
}

/** Thrusters on booms as wide as the feet: toppled, the ship lies on two of them. */
function addBooms(parts: Parts, reach: number, m: Scale): void {
  for (let n = 0; n < 4; n++) {
    const angle = ((n + 0.5) * Math.PI) / 2;
    const at = (r: number, z: number): [number, number, number] => [
      Math.cos(angle) * r,
      Math.sin(angle) * r,
      z,
    ];
    const z = m(1.55);
    addStrut(parts, FINISHES.grey, { from: at(m(1.3), m(1.75)), to: at(reach, z), radius: m(0.06) });
    addStrut(parts, FINISHES.grey, { from: at(m(1.3), m(1.05)), to: at(reach * 0.9, z), radius: m(0.045) });
    parts.add(box(m(0.3), m(0.3), m(0.34)), FINISHES.orange, { at: at(reach - m(0.15), z), spin: angle });
    for (const dz of [-0.24, 0.24])
      parts.add(tube(m(dz > 0 ? 0.05 : 0.11), m(dz > 0 ? 0.11 : 0.05), m(0.16), 8), FINISHES.dark, {
        at: at(reach - m(0.15), z + m(dz)),
      });
  }
}

function addCabin(parts: Parts, m: Scale): void {
  parts.add(
    turned(
      [
        [m(1.2), m(-0.5)],
        [m(1.3), m(0.2)],
        [m(1.56), m(1.2)],
        [m(1.4), m(1.95)],
        [m(0.86), m(2.5)],
        [m(0.52), m(2.62)],
      ],
      12,
    ),
    FINISHES.white,
    { at: [0, 0, 0] },
  );
  parts.add(tube(m(0.56), m(0.52), m(0.34), 20), FINISHES.grey, { at: [0, 0, m(2.72)] });
  parts.add(tube(m(0.4), m(0.4), m(0.36), 20), FINISHES.dark, { at: [0, 0, m(2.73)] });
  parts.add(ring(m(1.57), m(0.05), 12), FINISHES.grey, { at: [0, 0, m(1.28)] });
  // Hatch and two windows look along +x, where the ladder is.
  parts.add(box(m(0.12), m(0.9), m(1)), FINISHES.grey, { at: [m(1.53), 0, m(0.35)] });
  parts.add(box(m(0.14), m(0.7), m(0.8)), FINISHES.dark, { at: [m(1.54), 0, m(0.35)] });
  for (const side of [-1, 1]) {
    const along: [number, number, number] = [1, side * 0.42, 0.24];
    const at: [number, number, number] = [m(1.36), side * m(0.6), m(1.62)];
    parts.add(tube(m(0.36), m(0.36), m(0.16), 3), FINISHES.grey, { at, along, spin: side > 0 ? 0.5 : -0.5 });
    parts.add(tube(m(0.28), m(0.28), m(0.2), 3), FINISHES.glass, { at, along, spin: side > 0 ? 0.5 : -0.5 });
  }
  parts.add(ball(m(0.09), 8), FINISHES.port, { at: [0, m(1.5), m(1.9)] });
  parts.add(ball(m(0.09), 8), FINISHES.starboard, { at: [0, m(-1.5), m(1.9)] });
  parts.add(ball(m(0.1), 8), FINISHES.lamp, { at: [m(1.62), 0, m(1.05)] });
}

/** Dish and whip antenna. */
function addMast(parts: Parts, m: Scale): void {
  addStrut(parts, FINISHES.grey, {
    from: [m(-0.9), m(0.9), m(1.9)],
    to: [m(-1.25), m(1.25), m(2.75)],
    radius: m(0.05),
  });
  parts.add(
    turned([
      [m(0.03), 0],
      [m(0.35), m(0.07)],
      [m(0.55), m(0.2)],
    ]),
    FINISHES.white,
    { at: [m(-1.25), m(1.25), m(2.75)], along: [-0.5, 0.6, 0.7] },
  );
  addStrut(parts, FINISHES.silver, {
    from: [m(-0.8), m(-0.7), m(2.2)],
    to: [m(-1), m(-0.9), m(3.7)],
    radius: m(0.022),
  });
}

function addLadder(parts: Parts, { h, legRadius }: Stance, m: Scale): void {
  // Down the first leg, at 45°.
  const at = (r: number, side: number, z: number): [number, number, number] => [
    (r - m(side)) * Math.SQRT1_2,
    (r + m(side)) * Math.SQRT1_2,
    z,
  ];
  const [top, topZ] = [m(2.08), m(-0.65)];
  const [bottom, bottomZ] = [legRadius + m(0.12), -h + m(1.3)];
  for (const side of [-0.24, 0.24])
    addStrut(parts, FINISHES.silver, {
      from: at(top, side, topZ),
      to: at(bottom, side, bottomZ),
      radius: m(0.028),
    });
  for (let n = 0; n <= 7; n++) {
    const r = top + ((bottom - top) * n) / 7;
    const z = topZ + ((bottomZ - topZ) * n) / 7;
    addStrut(parts, FINISHES.silver, { from: at(r, -0.24, z), to: at(r, 0.24, z), radius: m(0.024) });
  }
}
