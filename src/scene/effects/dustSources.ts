import type { Dust } from './dust';
import { cellNoise } from '../ground/noise';

/** The members of a drawn ship that the dust depends on. Local axes, m, m/s. */
export interface DustyShip {
  readonly place: Float64Array;
  /** Relative to the turning ground. */
  readonly velocity: Float64Array;
  /** Ground under the ship, local y. */
  readonly groundY: number;
  readonly feetHeight: number;
  readonly legRadius: number;
  readonly grounded: boolean;
  readonly impactSpeed: number;
  /** Main engine, N, and the direction it blows. */
  readonly thrust: number;
  readonly blows: Float64Array;
}

/** Of a ship, between frames. */
export interface DustState {
  wasGrounded: boolean;
  owed: number;
  seed: number;
}

export function createDustState(): DustState {
  return { wasGrounded: true, owed: 0, seed: 0 };
}

const place = new Float64Array(3);
const velocity = new Float64Array(3);

/** Emits the grains that a touch, a slide and the exhaust raise in `seconds`. */
export function raiseDust(dust: Dust, state: DustState, ship: DustyShip, seconds: number): void {
  if (ship.grounded && !state.wasGrounded) splash(dust, state, ship);
  state.wasGrounded = ship.grounded;
  if (seconds <= 0) return;
  const speed = Math.hypot(ship.velocity[0]!, ship.velocity[2]!);
  if (ship.grounded && speed > 0.6) raiseSlidingDust(dust, state, ship, Math.min(speed * 18, 260) * seconds);
  if (ship.thrust > 0) sweep(dust, state, ship, seconds);
}

/** At a touch: a low fan from each foot, faster for a harder touch. */
function splash(dust: Dust, state: DustState, ship: DustyShip): void {
  const hard = Math.min(ship.impactSpeed, 40);
  const grains = Math.round(40 + hard * 11);
  for (let n = 0; n < grains; n++) {
    raiseAtFoot(ship, state, n % 4);
    const around = roll(state) * 2 * Math.PI;
    const out = hard * (0.12 + 0.5 * roll(state));
    const up = hard * (0.03 + 0.22 * roll(state) ** 2);
    velocity[0] = Math.cos(around) * out + ship.velocity[0]! * 0.25;
    velocity[1] = up;
    velocity[2] = Math.sin(around) * out + ship.velocity[2]! * 0.25;
    dust.throwGrain(place, velocity, {
      seconds: 2.2 + 2.4 * roll(state),
      size: 0.5 + 0.022 * hard * roll(state),
      opacity: 0.75,
    });
  }
}

/** Along a slide: from the feet, forward and to the sides. */
function raiseSlidingDust(dust: Dust, state: DustState, ship: DustyShip, grains: number): void {
  state.owed += grains;
  for (; state.owed >= 1; state.owed--) {
    raiseAtFoot(ship, state, Math.floor(roll(state) * 4));
    const [vx, vz] = [ship.velocity[0]!, ship.velocity[2]!];
    const side = (roll(state) - 0.5) * 1.1;
    const share = 0.2 + 0.75 * roll(state);
    velocity[0] = vx * share - vz * side;
    velocity[1] = Math.hypot(vx, vz) * (0.04 + 0.2 * roll(state) ** 2);
    velocity[2] = vz * share + vx * side;
    dust.throwGrain(place, velocity, { seconds: 1.8 + 1.6 * roll(state), size: 1.1, opacity: 0.75 });
  }
}

/** Where the exhaust hits the ground: flat sheets outward, weaker with height. */
function sweep(dust: Dust, state: DustState, ship: DustyShip, seconds: number): void {
  const down = -ship.blows[1]!;
  if (down < 0.3) return;
  const height = Math.max(0.5, ship.place[1]! - ship.groundY);
  const strength = (ship.thrust / 150_000) * Math.min(1, (16 / height) ** 2);
  if (strength < 0.03) return;
  state.owed += Math.min(strength * 280, 220) * seconds;
  const reach = height / down;
  const x = ship.place[0]! + ship.blows[0]! * reach;
  const z = ship.place[2]! + ship.blows[2]! * reach;
  for (; state.owed >= 1; state.owed--) {
    const around = roll(state) * 2 * Math.PI;
    const radius = 0.6 + roll(state) * (1 + height * 0.15);
    const out = (9 + 16 * roll(state)) * Math.min(1, 0.3 + strength);
    place[0] = x + Math.cos(around) * radius;
    place[1] = ship.groundY + 0.1;
    place[2] = z + Math.sin(around) * radius;
    velocity[0] = Math.cos(around) * out;
    velocity[1] = out * (0.03 + 0.12 * roll(state) ** 2);
    velocity[2] = Math.sin(around) * out;
    dust.throwGrain(place, velocity, { seconds: 1.1 + roll(state), size: 1.4, opacity: 0.62 });
  }
}

function raiseAtFoot(ship: DustyShip, state: DustState, foot: number): void {
  const around = ((foot + 0.5) * Math.PI) / 2 + (roll(state) - 0.5) * 0.5;
  const radius = ship.legRadius * (0.9 + 0.2 * roll(state));
  place[0] = ship.place[0]! + Math.cos(around) * radius;
  place[1] = ship.groundY + 0.08;
  place[2] = ship.place[2]! + Math.sin(around) * radius;
}

function roll(state: DustState): number {
  state.seed = (state.seed + 1) | 0;
  return cellNoise(state.seed, 3, 101);
}
