import { DEFAULT_SETTINGS } from '../../src/dynamics';
import type {
  BodyState,
  ClientFrame,
  Hello,
  InputRecord,
  ServerFrame,
  ShipState,
  WorldEvent,
} from '../../src/wire';

/** One message of each kind; no field has the default value that protobuf omits. */

export const BODY: BodyState = {
  name: 'Luna',
  mass: 7.342e22,
  radius: 1737400,
  position: [1.496e11, -2.5e9, 3.84e8],
  velocity: [29780.25, -12.5, 1022],
  attitude: [0.5, -0.5, 0.5, 0.5],
  angularVelocity: [1e-9, 2.66e-6, -3e-9],
};

export const SHIP: ShipState = {
  shipId: 'ship-1',
  playerId: 'player-1',
  name: 'Первый ☾',
  shipClass: 'fast_frigate',
  position: [1.496e11, -2.5e9, 3.857e8],
  velocity: [29780.5, -12.25, 1020],
  attitude: [0.1, 0.7, -0.1, 0.7],
  angularVelocity: [0.01, -0.02, 0.03],
  thrustLevel: 0.75,
  translationInput: [1, -0.5, 0.25],
  rotationInput: [-1, 0.5, 0.125],
  attitudeHold: true,
  attitudeMode: 'retrograde',
  targetAttitude: [-0.5, 0.5, 0.5, 0.5],
  fuel: 1234.5,
  mass: 9234.5,
  wheelMomentum: [100, -200, 0.5],
  groundContactOffset: 4.25,
  landedBodyName: 'Luna',
  surfaceContactState: 'contact',
  contactImpactSpeed: 12.5,
  referenceBody: 'Luna',
  relativePosition: [1.5, -2.5, 1737404],
  relativeVelocity: [0.5, 0.25, -1.75],
  crashed: true,
};

const ABOUT = { again: true, playerId: 'player-1', body: 'Moon', reason: 'collision' };

export const EVENT: WorldEvent = { type: 'ship.contact', shipId: 'ship-1', tick: 41, substep: 99, ...ABOUT };

export const FRAME: ServerFrame = {
  kind: 'frame',
  tick: 42,
  tickRate: 5,
  timeScale: 2.5,
  gameTime: 1234567.5,
  paused: true,
  bodies: [BODY, { ...BODY, name: 'Earth' }],
  ships: [SHIP, { ...SHIP, shipId: 'ship-2' }],
  events: [EVENT, { ...EVENT, type: 'ship.tipped' }],
  lastInput: { seq: 7, tick: 41, substep: 12, margin: -0.25 },
};

export const HELLO: Hello = {
  kind: 'hello',
  playerId: 'player-1',
  shipId: 'ship-1',
  settings: {
    ...DEFAULT_SETTINGS,
    touchdownAttitude: 'kept',
    contactFrictionKinetic: 0.25,
    surfaceNormal: 'terrain',
  },
  protocolVersion: '1.7',
  shipClasses: [
    {
      name: 'fast_frigate',
      dryMass: 8000,
      fuelCapacity: 4000,
      inertiaTensor: [
        [90000, 100, 200],
        [100, 91000, 300],
        [200, 300, 40000],
      ],
      groundContactOffset: 4,
      legRadius: 3,
      mainEngineThrust: 120000,
      mainEngineIsp: 15000,
      rcsThrust: [1000, 1001, 1002],
      rcsTorque: [8000, 8001, 8002],
      rcsLever: 2,
      rcsIsp: 300,
      reactionWheelTorque: [10, 11, 12],
      reactionWheelCapacity: [20, 21, 22],
      attitudeNaturalFrequency: 0.5,
      dryInertiaRatio: 0.625,
    },
  ],
  bodies: [BODY],
  terrain: 'hills',
  tick: 40,
  tickRate: 1,
  timeScale: 1,
  inputGranularity: 'substep',
};

export const INPUT: InputRecord = {
  seq: 1,
  tick: 42,
  substep: 3,
  controls: {
    thrustLevel: 0.5,
    translationInput: [0.5, -0.25, 1],
    rotationInput: [0.75, -1, 0.5],
    attitudeHold: true,
    attitudeMode: 'hold',
    targetAttitude: [0.5, 0.5, 0.5, -0.5],
  },
};

export const INPUTS: ClientFrame = { kind: 'inputs', inputs: [INPUT, { ...INPUT, seq: 2, substep: 4 }] };
