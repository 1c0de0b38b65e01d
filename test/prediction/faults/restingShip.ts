/** Messages of a server whose only ship is at rest on flat ground. */
import { BODIES, DEFAULT_SETTINGS, NEUTRAL_CONTROLS, SHIP_CLASSES } from '../../../src/dynamics';
import type { Hello, ServerFrame, ShipState } from '../../../src/wire';

const MOON = BODIES.find(({ name }) => name === 'Moon') ?? BODIES[0]!;
const BODY = {
  ...MOON,
  position: [0, 0, 0],
  velocity: [0, 0, 0],
  attitude: [0, 0, 0, 1],
  angularVelocity: [0, 0, 0],
} as const;
const UP = MOON.radius + SHIP_CLASSES[0]!.groundContactOffset;

/** A ship at rest on flat ground. */
export const STILL: ShipState = {
  shipId: 'ship-1',
  playerId: 'me',
  name: 'Own',
  shipClass: SHIP_CLASSES[0]!.name,
  position: [0, UP, 0],
  velocity: [0, 0, 0],
  attitude: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2],
  angularVelocity: [0, 0, 0],
  rotationInput: [0, 0, 0],
  translationInput: [0, 0, 0],
  thrustLevel: 0,
  attitudeHold: false,
  attitudeMode: NEUTRAL_CONTROLS.attitudeMode,
  targetAttitude: [0, 0, 0, 1],
  fuel: 100,
  mass: 0,
  wheelMomentum: null,
  groundContactOffset: null,
  landedBodyName: BODY.name,
  surfaceContactState: 'landed',
  contactImpactSpeed: 0,
  referenceBody: BODY.name,
  relativePosition: [0, UP, 0],
  relativeVelocity: [0, 0, 0],
  crashed: false,
} as unknown as ShipState;

export function frameAt(tick: number, tickRate: number, more: Partial<ServerFrame> = {}): ServerFrame {
  const tempo = { tickRate, timeScale: 1, paused: false };
  return {
    kind: 'frame',
    tick,
    ...tempo,
    bodies: [BODY],
    ships: [STILL],
    events: [],
    lastInput: null,
    ...more,
  };
}

export function helloAt(tick: number, tickRate: number, more: Partial<Hello> = {}): Hello {
  return {
    kind: 'hello',
    playerId: 'me',
    shipId: 'ship-1',
    settings: DEFAULT_SETTINGS,
    shipClasses: SHIP_CLASSES,
    bodies: [BODY],
    terrain: 'flat',
    tick,
    tickRate,
    timeScale: 1,
    inputGranularity: 'substep',
    ...more,
  };
}
