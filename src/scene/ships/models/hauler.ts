import { addLegs } from './legs';
import { createParts, FINISHES, type Parts } from './parts';
import { addStrut, ball, bell, box, ring, tube, turned } from './shapes';
import { type ShipModel, type Stance, thrusterClusters } from '../shipModel';

/** A truss tower with eight containers around it, tanks below, a bridge on top and four engines. */
export function buildHauler(stance: Stance): ShipModel {
  const parts = createParts();
  const s = stance.h / 8;
  const m = (share: number) => share * s;
  parts.add(box(m(6.6), m(6.6), m(0.5)), FINISHES.grey, { at: [0, 0, m(-3.1)] });
  parts.add(box(m(7), m(7), m(0.4)), FINISHES.grey, { at: [0, 0, m(-0.1)] });
  parts.add(box(m(7), m(7), m(0.4)), FINISHES.grey, { at: [0, 0, m(6.2)] });
  parts.add(tube(m(1.15), m(1.15), m(9.6), 12), FINISHES.dark, { at: [0, 0, m(1.5)] });
  addTruss(parts, m);
  addTanks(parts, m);
  addContainers(parts, m);
  addBridge(parts, m);
  const engines = [0, 90, 180, 270].map((degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const [x, y] = [Math.cos(angle) * m(2.6), Math.sin(angle) * m(2.6)];
    parts.add(tube(m(0.6), m(0.8), m(0.7), 12), FINISHES.grey, { at: [x, y, m(-3.6)] });
    parts.add(bell(m(1), m(1.9)), FINISHES.bell, { at: [x, y, m(-3.9)] });
    return { at: [x, y, m(-5.7)] as const, radius: m(0.9) };
  });
  addLegs(parts, stance, {
    hip: [m(3.6), m(-0.3)],
    brace: [m(3.3), m(-3)],
    spread: 0.55,
    thickness: m(0.3),
    padRadius: m(1.05),
    finish: FINISHES.sand,
  });
  return { ...parts.build(), engines, thrusters: thrusterClusters(m(5), m(6.2), Math.PI / 4) };
}

type Scale = (share: number) => number;

function addTruss(parts: Parts, m: Scale): void {
  for (const [x, y] of [
    [3.2, 3.2],
    [-3.2, 3.2],
    [-3.2, -3.2],
    [3.2, -3.2],
  ] as const) {
    addStrut(parts, FINISHES.sand, {
      from: [m(x), m(y), m(-3.2)],
      to: [m(x), m(y), m(6.2)],
      radius: m(0.16),
    });
    addStrut(parts, FINISHES.sand, { from: [m(x), m(y), m(-3)], to: [m(-y), m(x), m(-0.2)], radius: m(0.1) });
  }
}

function addTanks(parts: Parts, m: Scale): void {
  for (let n = 0; n < 4; n++) {
    const angle = ((n + 0.5) * Math.PI) / 2;
    const [x, y] = [Math.cos(angle) * m(2.1), Math.sin(angle) * m(2.1)];
    parts.add(ball(m(1.28), 20), FINISHES.white, { at: [x, y, m(-1.6)] });
    parts.add(ring(m(1.3), m(0.05)), FINISHES.grey, { at: [x, y, m(-1.6)] });
  }
}

function addContainers(parts: Parts, m: Scale): void {
  const finishes = [
    FINISHES.teal,
    FINISHES.orange,
    FINISHES.white,
    FINISHES.blue,
    FINISHES.sand,
    FINISHES.red,
    FINISHES.teal,
    FINISHES.sand,
  ];
  for (let n = 0; n < 8; n++) {
    const angle = ((n % 4) * Math.PI) / 2;
    const z = n < 4 ? 1.6 : 4.5;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const finish = finishes[n]!;
    const at = (r: number, dz: number): [number, number, number] => [cos * m(r), sin * m(r), m(z + dz)];
    parts.add(box(m(2.5), m(5.4), m(2.6)), finish, { at: at(2.75, 0), spin: angle });
    // Ribs and end frames.
    for (let rib = -2; rib <= 2; rib++) {
      const across = m(rib * 1.08);
      parts.add(box(m(0.1), m(0.28), m(2.5)), finish, {
        at: [cos * m(4.03) - sin * across, sin * m(4.03) + cos * across, m(z)],
        spin: angle,
      });
    }
    for (const dz of [-1.3, 1.3])
      parts.add(box(m(2.62), m(5.5), m(0.14)), FINISHES.grey, { at: at(2.75, dz), spin: angle });
  }
}

function addBridge(parts: Parts, m: Scale): void {
  parts.add(
    turned(
      [
        [m(2.7), m(6.4)],
        [m(2.7), m(7.5)],
        [m(2.2), m(8.3)],
        [m(1.2), m(8.6)],
        [0, m(8.65)],
      ],
      8,
    ),
    FINISHES.white,
    { at: [0, 0, 0] },
  );
  parts.add(
    turned(
      [
        [m(2.74), m(7.1)],
        [m(2.74), m(7.48)],
        [m(2.5), m(7.86)],
      ],
      8,
    ),
    FINISHES.glass,
    {
      at: [0, 0, 0],
    },
  );
  addAntennas(parts, m);
  addLamps(parts, m);
}

function addAntennas(parts: Parts, m: Scale): void {
  addStrut(parts, FINISHES.silver, {
    from: [m(1), m(1), m(8.4)],
    to: [m(1.2), m(1.2), m(10.4)],
    radius: m(0.05),
  });
  parts.add(
    turned([
      [0.02, 0],
      [m(0.7), m(0.12)],
      [m(1.1), m(0.4)],
    ]),
    FINISHES.white,
    {
      at: [m(-1.2), m(0.8), m(9)],
      along: [-0.6, 0.3, 0.7],
    },
  );
  addStrut(parts, FINISHES.grey, {
    from: [m(-1.2), m(0.8), m(8.3)],
    to: [m(-1.2), m(0.8), m(9)],
    radius: m(0.08),
  });
}

function addLamps(parts: Parts, m: Scale): void {
  parts.add(ball(m(0.14), 8), FINISHES.port, { at: [0, m(3.5), m(6.5)] });
  parts.add(ball(m(0.14), 8), FINISHES.starboard, { at: [0, m(-3.5), m(6.5)] });
  parts.add(ball(m(0.16), 8), FINISHES.lamp, { at: [m(3.5), 0, m(6.5)] });
  for (let n = 0; n < 4; n++) {
    const angle = Math.PI / 4 + (n * Math.PI) / 2;
    parts.add(box(m(0.6), m(0.6), m(0.7)), FINISHES.orange, {
      at: [Math.cos(angle) * m(4.8), Math.sin(angle) * m(4.8), m(6.2)],
      spin: angle,
    });
  }
}
