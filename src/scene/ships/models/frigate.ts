import type { BufferGeometry } from 'three';
import { createParts, FINISHES, type Parts } from './parts';
import { addStrut, ball, bell, box, plate, ring, tube, turned } from './shapes';
import { type ShipModel, type Stance, thrusterClusters } from '../shipModel';

/** A tail-sitter: slender hull on four swept fins whose tips are its feet. */
export function buildFrigate({ h, legRadius }: Stance): ShipModel {
  const parts = createParts();
  const s = h / 5;
  const m = (share: number) => share * s;
  parts.add(
    turned(
      [
        [m(1.15), m(-3.1)],
        [m(1.5), m(-2.2)],
        [m(1.72), m(-0.4)],
        [m(1.66), m(1.6)],
        [m(1.3), m(3.9)],
      ],
      20,
    ),
    FINISHES.white,
    { at: [0, 0, 0] },
  );
  parts.add(
    turned(
      [
        [m(1.3), m(3.9)],
        [m(0.78), m(5.5)],
        [m(0.22), m(6.5)],
        [0, m(6.62)],
      ],
      20,
    ),
    FINISHES.blue,
    { at: [0, 0, 0] },
  );
  for (const [z, radius] of [
    [-0.4, 1.735],
    [1.6, 1.675],
    [3.9, 1.315],
  ] as const)
    parts.add(ring(m(radius), m(0.035), 32), FINISHES.grey, { at: [0, 0, m(z)] });
  parts.add(tube(m(1.2), m(1.18), m(0.2), 20), FINISHES.dark, { at: [0, 0, m(-3.12)] });
  parts.add(bell(m(0.92), m(1.05)), FINISHES.bell, { at: [0, 0, m(-3.1)] });
  addCanopy(parts, m);
  addFins(parts, { h, legRadius }, m);
  parts.add(tube(m(0.03), m(0.012), m(1.1), 6), FINISHES.silver, { at: [0, 0, m(7.1)] });
  return {
    ...parts.build(),
    engines: [{ at: [0, 0, m(-4.05)], radius: m(0.8) }],
    thrusters: [
      ...thrusterClusters(m(1.35), m(4), Math.PI / 4),
      ...thrusterClusters(m(1.6), m(-2), Math.PI / 4),
    ],
  };
}

function addCanopy(parts: Parts, m: (share: number) => number): void {
  parts.add(ball(m(0.62), 16), FINISHES.glass, {
    at: [m(0.92), 0, m(4.2)],
    along: [-0.33, 0, 1],
    scale: [0.6, 0.75, 1.6],
  });
  for (const side of [-1, 1])
    parts.add(ball(m(0.2), 12), FINISHES.glass, { at: [m(0.95), side * m(0.95), m(3.2)] });
  parts.add(ball(m(0.09), 8), FINISHES.port, { at: [0, m(1.72), m(0.4)] });
  parts.add(ball(m(0.09), 8), FINISHES.starboard, { at: [0, m(-1.72), m(0.4)] });
  for (const side of [-1, 1])
    parts.add(box(m(1.2), m(0.1), m(2.6)), FINISHES.grey, {
      at: [m(-1.05), side * m(1.05), m(0.4)],
      spin: side * 0.78,
    });
}

function addFins(parts: Parts, { h, legRadius }: Stance, m: (share: number) => number): void {
  for (let leg = 0; leg < 4; leg++) {
    const azimuth = ((leg + 0.5) * Math.PI) / 2;
    const reach = legRadius;
    // In (x, z) of body axes, turned to the leg's azimuth; two plates, since the whole is not convex.
    const root: [number, number][] = [
      [m(1.1), m(-2.6)],
      [reach * 0.8, m(-2.9)],
      [reach * 0.94, m(-2.5)],
      [m(1.2), m(1.4)],
    ];
    const tip: [number, number][] = [
      [reach * 0.8, m(-2.9)],
      [reach * 0.95, -h + m(0.75)],
      [reach * 1.03, -h + m(0.85)],
      [reach * 0.94, m(-2.5)],
    ];
    parts.add(plate(root, m(0.2)), FINISHES.orange, { at: [0, 0, 0], spin: azimuth });
    parts.add(plate(tip, m(0.2)), FINISHES.orange, { at: [0, 0, 0], spin: azimuth });
    parts.add(canard(reach, m), FINISHES.orange, { at: [0, 0, 0], spin: azimuth });
    const at = (r: number, z: number): [number, number, number] => [
      r * Math.cos(azimuth),
      r * Math.sin(azimuth),
      z,
    ];
    addStrut(parts, FINISHES.grey, {
      from: at(reach, -h + m(0.7)),
      to: at(reach, m(-2.35)),
      radius: m(0.17),
    });
    addStrut(parts, FINISHES.silver, {
      from: at(reach, -h + m(0.15)),
      to: at(reach, -h + m(1.6)),
      radius: m(0.1),
      flex: { leg, low: 1, high: 1 },
    });
    parts.add(
      turned([
        [0, 0],
        [m(0.4), 0],
        [m(0.44), m(0.09)],
        [m(0.14), m(0.22)],
        [0, m(0.24)],
      ]),
      FINISHES.grey,
      { at: at(reach, -h), flex: { leg, low: 1, high: 1 } },
    );
  }
}

/** Upper fins as wide as the feet: toppled, the ship lies on them and not on air. */
function canard(reach: number, m: (share: number) => number): BufferGeometry {
  const outline: [number, number][] = [
    [m(1.3), m(3.2)],
    [reach, m(3.3)],
    [reach * 0.98, m(3.75)],
    [m(1.1), m(4.2)],
  ];
  return plate(outline, m(0.12));
}
