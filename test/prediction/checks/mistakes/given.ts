/** Runs a predictor and collects its warnings: a ship landed on the Moon, its frame, its hello. */
import { BODIES, DEFAULT_SETTINGS, NEUTRAL_CONTROLS, SHIP_CLASSES } from '../../../../src/dynamics';
import {
  createLeanPredictor,
  createPredictor,
  gameCatalogue,
  type LeanPredictor,
  type Predictor,
  type PredictorOptions,
} from '../../../../src/prediction';
import type { Hello, ServerFrame, ShipState } from '../../../../src/wire';

export const LUNA = BODIES.find(({ name }) => name === 'Luna')!;
export const HEIGHT = LUNA.radius + 4.56;

/** A ship landed on the Moon, upright along +X. */
export const ship: ShipState = {
  shipId: 'a',
  playerId: 'p',
  name: 'A',
  shipClass: 'planetary_lander',
  position: [LUNA.position[0] + HEIGHT, LUNA.position[1], LUNA.position[2]],
  velocity: LUNA.velocity,
  // +Z of the ship along +X.
  attitude: [0, Math.SQRT1_2, 0, Math.SQRT1_2],
  angularVelocity: [0, 0, 0],
  rotationInput: [0, 0, 0],
  translationInput: [0, 0, 0],
  thrustLevel: 0,
  attitudeHold: false,
  attitudeMode: 'none',
  targetAttitude: [0, 0, 0, 1],
  fuel: 100,
  mass: 1000,
  wheelMomentum: null,
  groundContactOffset: null,
  landedBodyName: 'Luna',
  surfaceContactState: 'landed',
  contactImpactSpeed: null,
  referenceBody: '',
  relativePosition: null,
  relativeVelocity: null,
  crashed: false,
};
export const frame: ServerFrame = {
  kind: 'frame',
  tick: 1,
  tickRate: 1,
  timeScale: 1,
  paused: false,
  bodies: [LUNA],
  ships: [ship],
  events: [],
  lastInput: null,
};
export const hello: Hello = {
  kind: 'hello',
  playerId: 'p',
  shipId: 'a',
  settings: DEFAULT_SETTINGS,
  shipClasses: SHIP_CLASSES,
  bodies: [LUNA],
  terrain: 'flat',
  tick: 1,
  tickRate: 1,
  timeScale: 1,
  inputGranularity: 'tick',
};
export const withShip = (changes: object): ServerFrame => ({ ...frame, ships: [{ ...ship, ...changes }] });
export const withBody = (changes: object): ServerFrame => ({
  ...frame,
  bodies: [{ ...LUNA, ...changes }],
});
export const thousandth = (v: readonly number[]) => v.map((x) => x / 1000);

/** A mistake, the expected code, a part of the expected message, and a function that makes it. */
export type Mistake = readonly [what: string, code: string, help: RegExp, run: () => Warning[]];

export interface Warning {
  readonly code: string;
  readonly message: string;
  readonly details: Readonly<Record<string, unknown>>;
}

/** The warnings of a predictor while `use` runs. */
export const warningsOf = (use: (predictor: Predictor) => void, options: object = {}): Warning[] =>
  warningsOfOne(createPredictor, use, options);

/** The same of a lean predictor that has the game's classes and bodies alone. */
export const warningsOfLean = (use: (predictor: LeanPredictor) => void): Warning[] =>
  warningsOfOne(createLeanPredictor, use, { features: [gameCatalogue] });

function warningsOfOne<P>(
  create: (options: PredictorOptions) => P,
  use: (predictor: P) => void,
  options: object,
) {
  const found: Warning[] = [];
  use(
    create({
      ownShipId: 'a',
      onWarning: (code, message, details) => found.push({ code, message, details }),
      ...options,
    }),
  );
  return found;
}

export const made = (options: object) => warningsOf(() => undefined, options);
export const received = (...messages: unknown[]) =>
  warningsOf((p) => messages.forEach((message, i) => p.receive(message as ServerFrame, i)));
export const flown = (controls: unknown) =>
  warningsOf((p) => {
    p.receive(frame, 0);
    p.advance(controls as typeof NEUTRAL_CONTROLS, 0.01);
  });
/** Frames at 60 Hz and states at 1 Hz for `seconds`, with the arguments of each call. */
export const played = (
  seconds: number,
  {
    now = (s: number): number => s,
    hz = 60,
    times = 1,
    receiveAt = (s: number) => s,
    viewAt = null as ((s: number) => number) | null,
    id = 'a',
    take = true,
  } = {},
) =>
  warningsOf((p) => {
    for (let i = 0; i < seconds * hz; i++) {
      const at = i / hz;
      if (i % hz === 0)
        p.receive({ ...frame, tick: 1 + i / hz, ships: [{ ...ship, shipId: id }] }, receiveAt(at));
      for (let k = 0; k < times; k++)
        p.advance({ ...NEUTRAL_CONTROLS, thrustLevel: i % 2 ? 0.001 : 0 }, now(at));
      p.view((viewAt ?? now)(at));
      if (take) p.takeOutgoing();
    }
  });

/** Frames of `count` ticks, one per second. */
export const ticks = (count: number, changes: object = {}) =>
  Array.from({ length: count }, (_, i) => ({ ...frame, ...changes, tick: i + 1 }));
/** A dozen frames and display frames with these options, after a hello if there is one. */
export const frames = (options: object, first: Hello | null = null) =>
  warningsOf((p) => {
    if (first !== null) p.receive(first, 0);
    for (const [i, one] of ticks(12).entries()) {
      p.receive({ ...one, tick: i + 2 }, i + 1);
      p.advance(null, i + 1.01);
    }
  }, options);
/** Options with this terrain. */
export const ground = (height: () => unknown) => ({
  terrains: { mine: height },
  defaults: { terrain: 'mine' },
});
