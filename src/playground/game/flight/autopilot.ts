import { type Controls, NEUTRAL_CONTROLS, type Quat, type TerrainHeight, type Vec3 } from '../../../dynamics';
import type { ShipView, WorldView } from '../../../prediction';
import { BEGIN_LANDING, brakeDrift, continueLanding, type LandingManeuver } from '../../../scenarios';
import type { ShipState } from '../../../wire';
import { placeName } from '../texts/placeName';

/** The landing autopilot, switched on and off by one key. */
export interface Autopilot {
  readonly isOn: () => boolean;
  /** Why it switched itself off, until it is switched on again; otherwise ''. */
  readonly reason: () => string;
  readonly set: (on: boolean) => void;
  /** Where it lands, the body's axes; null, as at first: below the ship. */
  readonly landAt: (target: () => Vec3 | null) => void;
  /** Controls now; a new sample a few times a second, from the predicted state. */
  readonly fly: (view: WorldView, now: number) => Controls;
}

/** Samples per second; each is an input that is sent. */
const RATE = 5;
/** Game seconds: samples of a page that hardly runs are not planned further apart than this. */
const LONGEST = 3;
/** Steps of its commands, those of lever and sticks, so that links can carry its flights too. */
const LEVER_STEP = 0.005;
const STICK_STEPS = 100;

/** @param terrainHeight the ground of the present world */
export function createAutopilot(terrainHeight: () => TerrainHeight): Autopilot {
  let isOn = false;
  let reason = '';
  let landing: LandingManeuver = BEGIN_LANDING;
  let controls = NEUTRAL_CONTROLS;
  let isBraking = false;
  let target: () => Vec3 | null = () => null;
  let sampledAt = -Infinity;
  /** Of the view: the time of the call before. */
  let seenAt = -Infinity;

  const begin = () => {
    landing = BEGIN_LANDING;
    isBraking = false;
    sampledAt = -Infinity;
    seenAt = -Infinity;
  };
  const end = (why: string) => {
    isOn = false;
    reason = why;
  };
  return {
    isOn: () => isOn,
    reason: () => reason,
    set(on) {
      // Already off: it disengaged by itself, and its reason stays.
      if (on !== isOn) reason = '';
      isOn = on;
      begin();
    },
    landAt: (next) => (target = next),
    fly(view, now) {
      const ship = view.own;
      const body = ship === null ? undefined : view.bodies[ship.body];
      const age = sinceOf(seenAt, now);
      seenAt = now;
      if (ship === null || body === undefined) return controls;
      if (now - sampledAt < 1 / RATE && now >= sampledAt) return controls;
      const delay = age + sinceOf(sampledAt, now) / 2;
      sampledAt = now;
      const below = { body, shipClass: ship.shipClass, terrainHeight: terrainHeight(), delay };
      const place = target();
      const site = place === null ? below : { ...below, target: place };
      const state = stateOf(ship, body.name);
      const braking = state.surfaceContactState === '' ? brakeDrift(isBraking, state, site) : null;
      const burn = braking?.ok === true ? braking.value : null;
      isBraking = burn !== null;
      if (burn !== null) return (controls = onGrid(burn));
      const next = continueLanding(landing, state, site);
      if (!next.ok) {
        end(next.reason);
        return controls;
      }
      landing = next.value;
      controls = onGrid(landing.controls);
      if (landing.phase === 'complete') end('');
      else if (landing.phase === 'failed') end(landing.reason.replace(body.name, placeName(body.name)));
      return controls;
    },
  };
}

/** Game seconds from `then`; at first those of one sample. */
function sinceOf(then: number, now: number): number {
  return now > then && then > -Infinity ? Math.min(now - then, LONGEST) : 1 / RATE;
}

/** The ship state for the landing, from the predicted state. */
function stateOf(ship: ShipView, bodyName: string): ShipState {
  const triple = (v: Float64Array): Vec3 => [v[0]!, v[1]!, v[2]!];
  const attitude: Quat = [ship.attitude[0]!, ship.attitude[1]!, ship.attitude[2]!, ship.attitude[3]!];
  return {
    shipId: ship.shipId,
    position: triple(ship.position),
    velocity: triple(ship.velocity),
    relativePosition: triple(ship.position),
    relativeVelocity: triple(ship.velocity),
    attitude,
    angularVelocity: triple(ship.angularVelocity),
    mass: ship.shipClass.dryMass + ship.fuel,
    fuel: ship.fuel,
    surfaceContactState: ship.surfaceContactState,
    contactImpactSpeed: ship.impactSpeed,
    landedBodyName: ship.surfaceContactState === '' ? '' : bodyName,
    crashed: ship.crashed,
  } as unknown as ShipState;
}

function onGrid(controls: Controls): Controls {
  const round = (v: Vec3): Vec3 => [
    Math.round(v[0] * STICK_STEPS) / STICK_STEPS + 0,
    Math.round(v[1] * STICK_STEPS) / STICK_STEPS + 0,
    Math.round(v[2] * STICK_STEPS) / STICK_STEPS + 0,
  ];
  return {
    ...controls,
    thrustLevel: Math.round(controls.thrustLevel / LEVER_STEP) * LEVER_STEP,
    translationInput: round(controls.translationInput),
    rotationInput: round(controls.rotationInput),
  };
}
