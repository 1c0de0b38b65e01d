import {
  type Body,
  type BodyMotion,
  type Controls,
  NEUTRAL_CONTROLS,
  type Quat,
  type ShipClass,
  type ShipInit,
  type Vec3,
} from '../../../src/dynamics';
import type { BodyState, ServerFrame, ShipState } from '../../../src/wire';
import { type ContactOptions, type LiteralBody, type LiteralShip, updateShip } from './contactStep';
import { conjugate, cross, length, minus, multiply, plus, rotate, rotationBy, scale } from './vectors';

/**
 * A server written from the design alone, as the game's may be: one step per tick, no substeps, no relative fields, no events, no
 * acknowledgements, whole-tick controls; ticks at `hz` and sends every `every` ticks. Its client may be given wrong values.
 */
export interface LiteralOptions extends ContactOptions {
  readonly hz: number;
  readonly every: number;
  /** Game s per wall s; it sends 1. */
  readonly timeScale: number;
  readonly sendsBodies: boolean;
  /** The body's real spin divided by the one sent, and whether the attitudes sent turn with the real one. */
  readonly spinFactor: number;
  readonly tellsAttitude: boolean;
}

export interface LiteralWorld {
  readonly body: Body & BodyMotion;
  readonly ships: readonly {
    readonly id: string;
    readonly shipClass: ShipClass;
    readonly ship: ShipInit;
  }[];
}

/** A server that has run for a while. */
export const FIRST_TICK = 1000;

/** A ship's true state at a tick. */
export interface LiteralTruth {
  /** Relative to the body's centre, ICRF axes. */
  readonly position: Vec3;
  readonly velocity: Vec3;
  readonly attitude: Quat;
  readonly state: string;
}

export interface LiteralServer {
  /** The frame of the present tick, sent to a client at once. */
  readonly frame: () => ServerFrame;
  /** Runs one tick. Returns the frame if this tick is sent. */
  readonly tick: () => ServerFrame | null;
  readonly control: (shipId: string, controls: Controls) => void;
  readonly truthAt: (shipId: string, tick: number) => LiteralTruth | undefined;
}

export function createLiteralServer(world: LiteralWorld, options: LiteralOptions): LiteralServer {
  const told = world.body;
  const body: LiteralBody = {
    ...told,
    angularVelocity: scale(told.angularVelocity, options.spinFactor),
  };
  let toldAttitude = told.attitude;
  const ships = world.ships.map(({ id, shipClass, ship }) => place(id, shipClass, ship, { body, told }));
  const truths = new Map(ships.map(({ id }) => [id, [] as LiteralTruth[]]));
  const dt = options.timeScale / options.hz;
  let tick = FIRST_TICK;
  remember();

  function remember(): void {
    for (const ship of ships) {
      truths.get(ship.id)!.push({
        position: minus(ship.position, body.position),
        velocity: minus(ship.velocity, body.velocity),
        attitude: ship.attitude,
        state: ship.crashed ? 'crashed' : ship.state,
      });
    }
  }

  function frame(): ServerFrame {
    const attitude = options.tellsAttitude ? body.attitude : toldAttitude;
    const { position, velocity } = body;
    const bodies: BodyState[] = [{ ...told, position, velocity, attitude }];
    return {
      kind: 'frame',
      tick,
      tickRate: options.hz,
      timeScale: 1,
      paused: false,
      bodies: options.sendsBodies ? bodies : [],
      ships: ships.map((ship) => stateOf(ship, told.name)),
      events: [],
      lastInput: null,
    };
  }

  return {
    frame,
    tick() {
      body.position = plus(body.position, scale(body.velocity, dt));
      body.attitude = multiply(rotationBy(scale(body.angularVelocity, dt)), body.attitude);
      toldAttitude = multiply(rotationBy(scale(told.angularVelocity, dt)), toldAttitude);
      for (const ship of ships) updateShip(ship, body, options, dt);
      tick += 1;
      remember();
      return tick % options.every === 0 ? frame() : null;
    },
    control(shipId, controls) {
      const ship = ships.find(({ id }) => id === shipId);
      if (ship !== undefined) ship.controls = controls;
    },
    truthAt: (shipId, at) => truths.get(shipId)?.[at - FIRST_TICK],
  };
}

/** The ship's initial state, on ground that turns at the real rate. */
function place(
  id: string,
  shipClass: ShipClass,
  ship: ShipInit,
  { body, told }: { readonly body: LiteralBody; readonly told: BodyMotion },
): LiteralShip {
  const r = ship.relativePosition;
  const faster = cross(minus(body.angularVelocity, told.angularVelocity), r);
  const state = ship.surfaceContactState;
  const distance = length(r);
  const back = conjugate(body.attitude);
  return {
    id,
    shipClass,
    fuel: ship.fuel,
    state,
    crashed: false,
    impact: 0,
    position: plus(body.position, r),
    velocity: plus(body.velocity, plus(ship.relativeVelocity, faster)),
    attitude: ship.attitude,
    angularVelocity: ship.angularVelocity,
    rest: {
      normal: rotate(back, scale(r, 1 / distance)),
      distance,
      attitude: multiply(back, ship.attitude),
    },
    controls: NEUTRAL_CONTROLS,
  };
}

function stateOf(ship: LiteralShip, bodyName: string): ShipState {
  const { id, shipClass, controls } = ship;
  return {
    shipId: id,
    playerId: id,
    name: id,
    shipClass: shipClass.name,
    position: ship.position,
    velocity: ship.velocity,
    attitude: ship.attitude,
    angularVelocity: ship.angularVelocity,
    ...controls,
    fuel: ship.fuel,
    mass: shipClass.dryMass + ship.fuel,
    landedBodyName: ship.state === '' ? '' : bodyName,
    surfaceContactState: ship.state,
    contactImpactSpeed: null,
    wheelMomentum: null,
    groundContactOffset: null,
    referenceBody: '',
    relativePosition: null,
    relativeVelocity: null,
    crashed: ship.crashed,
  };
}
