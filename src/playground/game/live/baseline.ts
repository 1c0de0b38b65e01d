import { GRAVITATIONAL_CONSTANT } from '../../../dynamics';
import type { WorldView } from '../../../prediction';
import type { PartialFrame, ShipState } from '../../../wire';
import type { ClientMode } from '../../panels/choices';

/**
 * The picture drawn like other clients, for comparison: the last state held, or extrapolated under gravity alone like the current
 * client (without its blending). Only the drawn poses are overwritten; HUD numbers stay the predictor's.
 */
export interface Baseline {
  readonly take: (frame: PartialFrame, now: number) => void;
  readonly forget: () => void;
  /** Overwrites the drawn poses of `view`. */
  readonly redraw: (view: WorldView, mode: ClientMode, now: number) => void;
}

interface Held {
  readonly frame: PartialFrame;
  readonly at: number;
}

export function createBaseline(): Baseline {
  let held: Held | null = null;
  return {
    take(frame, now) {
      held = { frame, at: now };
    },
    forget() {
      held = null;
    },
    redraw(view, mode, now) {
      if (held === null || mode === 'predicted') return;
      const { frame, at } = held;
      const seconds = frame.paused ? 0 : (now - at) * (frame.timeScale ?? 1);
      for (const ship of view.ships) {
        const state = frame.ships.find(({ shipId }) => shipId === ship.shipId);
        const body = view.bodies[ship.body];
        if (state === undefined || body === undefined) continue;
        const place = relativePlace(state, frame, body.name);
        if (mode === 'gravity' && state.surfaceContactState === '') fall(place, seconds, body.mass);
        // Ground-bound ships stay on the turning ground; the body's rotation within a tick is small.
        else carryWithGround(place, body.angularVelocity, seconds);
        ship.easedPosition.set(place.position);
        ship.meshPosition.set(place.position);
        ship.meshAttitude.set(state.attitude);
        ship.legCompression.fill(0);
      }
    },
  };
}

interface Place {
  readonly position: [number, number, number];
  readonly velocity: [number, number, number];
}

function relativePlace(state: ShipState, frame: PartialFrame, bodyName: string): Place {
  if (state.relativePosition !== null && state.relativeVelocity !== null)
    return { position: [...state.relativePosition], velocity: [...state.relativeVelocity] };
  const body = frame.bodies?.find(({ name }) => name === bodyName);
  const from = (a: readonly number[], b: readonly number[] | undefined): [number, number, number] => [
    a[0]! - (b?.[0] ?? 0),
    a[1]! - (b?.[1] ?? 0),
    a[2]! - (b?.[2] ?? 0),
  ];
  return {
    position: from(state.position, body?.position),
    velocity: from(state.velocity, body?.velocity),
  };
}

/** Under the gravity of the place where it began: m/s² along −r. */
function fall({ position, velocity }: Place, seconds: number, mass: number): void {
  const range = Math.hypot(...position);
  const pull = (-GRAVITATIONAL_CONSTANT * mass) / range ** 3;
  for (let i = 0; i < 3; i++)
    position[i] = position[i]! + velocity[i]! * seconds + 0.5 * pull * position[i]! * seconds * seconds;
}

function carryWithGround(
  { position }: Place,
  spin: readonly [number, number, number],
  seconds: number,
): void {
  const [x, y, z] = position;
  position[0] = x + (spin[1] * z - spin[2] * y) * seconds;
  position[1] = y + (spin[2] * x - spin[0] * z) * seconds;
  position[2] = z + (spin[0] * y - spin[1] * x) * seconds;
}
