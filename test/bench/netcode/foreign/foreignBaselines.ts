import type { Vec3 } from '../../../../src/dynamics';
import type { ServerFrame } from '../../../../src/wire';
import type { LiteralRig } from '../../../prediction/literalServer/literalRig';
import { FIRST_TICK } from '../../../prediction/literalServer/literalServer';
import { length, minus, plus, scale } from '../../../prediction/literalServer/vectors';
import { SHIP } from '../../../prediction/rig';
import type { Placed } from './foreign';

/** Drawing the same frames without prediction: gravity-only extrapolation with blending, and interpolation one send behind. */
export interface Carried {
  readonly receive: (frame: ServerFrame, now: number) => void;
  readonly draw: (ticks: number, now: number) => { gravity: Placed | null; behind: Placed | null };
}

interface Known {
  readonly tick: number;
  readonly position: Vec3;
  readonly velocity: Vec3;
  readonly state: string;
}

/** s after which the blend leaves 5 %, as in the current client. */
const BLEND_RATE = 3 / 0.5;

export function createForeignBaselines({ loaded, terrainHeight }: LiteralRig, G: number): Carried {
  const { body, shipClass } = loaded;
  const kept: Known[] = [];
  let fresh = false;
  let offset: Vec3 = [0, 0, 0];
  let offsetAt = 0;
  let last: Vec3 | null = null;
  let rate = 50;
  // Relative to the body extrapolated by its velocity: bodies may not be sent.
  const bodyAt = (tick: number): Vec3 =>
    plus(body.position, scale(body.velocity, (tick - FIRST_TICK) / rate));

  function placed(position: Vec3, state: string): Placed {
    const r = length(position);
    const ground = body.radius + terrainHeight(body.name, position[0] / r, position[1] / r, position[2] / r);
    return { position, state, underground: Math.max(0, ground + shipClass.groundContactOffset - r) };
  }

  function blended(target: Vec3, now: number): Vec3 {
    if (fresh && last !== null) offset = minus(last, target);
    else offset = scale(offset, Math.exp(-BLEND_RATE * (now - offsetAt)));
    fresh = false;
    offsetAt = now;
    last = plus(target, offset);
    return last;
  }

  return {
    receive(frame) {
      const ship = frame.ships.find(({ shipId }) => shipId === SHIP);
      if (ship === undefined) return;
      rate = frame.tickRate;
      const centre = frame.bodies[0]?.position ?? bodyAt(frame.tick);
      const state = ship.crashed ? 'crashed' : ship.surfaceContactState;
      const velocity = minus(ship.velocity, body.velocity);
      kept.push({ tick: frame.tick, position: minus(ship.position, centre), velocity, state });
      if (kept.length > 4) kept.shift();
      fresh = true;
    },
    draw(ticks, now) {
      const newest = kept.at(-1);
      if (newest === undefined) return { gravity: null, behind: null };
      const seconds = (ticks - newest.tick) / rate;
      const { position: p, velocity: v } = newest;
      const pull = (-G * body.mass) / length(p) ** 3;
      const target = plus(plus(p, scale(v, seconds)), scale(p, 0.5 * pull * seconds * seconds));
      const before = kept.at(-2);
      const share =
        before === undefined ? 1 : Math.min(1, (ticks - newest.tick) / (newest.tick - before.tick));
      const behind =
        before === undefined
          ? p
          : plus(before.position, scale(minus(p, before.position), Math.max(0, share)));
      return {
        gravity: placed(blended(target, now), newest.state),
        behind: placed(behind, before?.state ?? newest.state),
      };
    },
  };
}
