import { expect, it } from 'vitest';
import {
  BODY_STRIDE,
  hillsTerrain,
  loadBody,
  loadShipClass,
  REFERENCE_BODY,
  SHIP_CLASS,
  SHIP_STRIDE,
  stepWorld,
  type World,
} from '../../src/dynamics';
import { bodyNamed, classNamed, createTrial, LANDER, must, type Setup, stepOnce } from './provingGround';

// A substep keeps what it read of a world, a ship class and a body for the next ship: none of it may reach a ship of another.

const SUBSTEPS = 150;
const SLIDING = { state: 'contact', velocity: [9, 0, 0] } as const;

const IN_WORLDS_OF_THEIR_OWN: Readonly<Record<string, Setup>> = {
  'as it is': SLIDING,
  'with other settings': { ...SLIDING, settings: { contactFrictionKinetic: 0.2 } },
  'with another class': { ...SLIDING, shipClass: classNamed('cargo_hauler') },
  'on another body': { ...SLIDING, body: bodyNamed('Mars') },
  'on other terrain': { ...SLIDING, terrain: () => -0.3 },
  'on slopes': { ...SLIDING, terrain: hillsTerrain, settings: { surfaceNormal: 'terrain' } },
};

function distinct(rows: readonly Float64Array[]): number {
  return new Set(rows.map((row) => row.join(' '))).size;
}

it('ships stepped in turn, each in another world, move as each does alone', () => {
  const setups = Object.values(IN_WORLDS_OF_THEIR_OWN);
  const alone = setups.map((setup) => {
    const trial = createTrial(setup);
    for (let i = 0; i < SUBSTEPS; i++) stepOnce(trial);
    return trial.ships;
  });
  const inTurn = setups.map((setup) => createTrial(setup));
  for (let i = 0; i < SUBSTEPS; i++) for (const trial of inTurn) stepOnce(trial);
  expect(inTurn.map(({ ships }) => ships)).toEqual(alone);
  expect(distinct(alone)).toBe(setups.length);
});

/** [class, body] of each row: from one to the next either the class changes or the body. */
const MIXED = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
] as const;

/** Two classes over two bodies in one world. */
function mixed(): { world: World; ships: Float64Array; bodies: Float64Array } {
  const classes = [LANDER, classNamed('cargo_hauler')];
  const moving = [bodyNamed('Luna'), bodyNamed('Mars')];
  const ships = new Float64Array(MIXED.length * SHIP_STRIDE);
  const bodies = new Float64Array(moving.length * BODY_STRIDE);
  for (const [i, [c, b]] of MIXED.entries()) {
    const trial = createTrial({ ...SLIDING, shipClass: classes[c]!, body: moving[b]! });
    ships.set(trial.ships, i * SHIP_STRIDE);
    ships[i * SHIP_STRIDE + SHIP_CLASS] = c;
    ships[i * SHIP_STRIDE + REFERENCE_BODY] = b;
    bodies.set(trial.bodies, b * BODY_STRIDE);
  }
  const shipClasses = classes.map((shipClass) => must(loadShipClass(shipClass)));
  const loaded = moving.map((body) => must(loadBody(body)));
  return { world: { ...createTrial({}).world, shipClasses, bodies: loaded }, ships, bodies };
}

it('ships of two classes over two bodies in one world move as each does alone', () => {
  const together = mixed();
  const events = new Uint8Array(4);
  for (let i = 0; i < SUBSTEPS; i++) stepWorld(together.ships, together.bodies, events, together.world, 0.01);
  const rows = MIXED.map((_, i) => together.ships.slice(i * SHIP_STRIDE, (i + 1) * SHIP_STRIDE));
  const alone = rows.map((_, i) => {
    const { world, ships, bodies } = mixed();
    const row = ships.slice(i * SHIP_STRIDE, (i + 1) * SHIP_STRIDE);
    for (let k = 0; k < SUBSTEPS; k++) stepWorld(row, bodies, events, world, 0.01);
    return row;
  });
  expect(rows).toEqual(alone);
  expect(distinct(rows)).toBe(4);
});
