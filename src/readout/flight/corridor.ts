import type { ShipView } from '../../prediction';
import type { Surface } from '../surface';

/** Members of LandingAids, where they are documented. */
interface Corridor {
  burnSeconds: number;
  aimSpeed: number;
  corridor: 'slow' | 'good' | 'fast' | 'none';
  advice: 'more' | 'hold' | 'less' | 'push' | 'none';
}

/** m/s over the last metres; the goal of a landing is below 2. */
const TOUCH_SPEED = 1.2;
/** Highest speed to aim at, m/s. */
const MAX_SPEED = 30;
const LAST_METRES = 2;
/** Share of the engine's braking beyond gravity; the rest is a reserve for braking late. */
const BRAKING_SHARE = 0.5;
/** m/s²: so that a ship still descends where there is next to no gravity. */
const MIN_BRAKING = 0.3;
/** Share of that braking on the way down: slow enough to be followed by hand. */
const FLOWN_SHARE = 0.25;
/** Shares of the speed to aim at that bound the corridor. */
const SLOWEST = 0.5;
const FASTEST = 1.35;
/** m/s: close to the ground a share alone would be too narrow. */
const SLACK = 0.5;

/** Game s from a look at the display to the hand's reaction. */
const LEAD = 1.5;
/** Shares of the speed to aim at, and m/s, within which the throttle stays: narrower on the fast side, which ends in a hard touch. */
const ADVISED = { slowest: 0.45, fastest: 1.1, slack: 0.3 };

/** Stopping from v at full thrust takes v² / (2 a): the fall until then is solved for its time, upright and over level ground. */
export function measureCorridor(
  out: Corridor,
  { gravity, mass, radialSpeed, clearance }: Surface,
  ship: ShipView,
): void {
  const falling = -radialSpeed;
  const height = Math.max(0, clearance);
  const full = ship.fuel > 0 ? ship.shipClass.mainEngineThrust / mass : 0;
  const braking = full - gravity;
  if (braking <= 0) {
    out.burnSeconds = falling > 0 ? 0 : NaN;
    out.aimSpeed = NaN;
    out.corridor = 'none';
    out.advice = 'none';
    return;
  }
  const spare = falling * falling - 2 * braking * height;
  const discriminant = falling * falling - (gravity * spare) / full;
  // Below 0 it is too late; the discriminant is not below 0 while something falls, since full > gravity.
  out.burnSeconds = falling > 0 ? Math.max(0, (Math.sqrt(discriminant) - falling) / gravity) : NaN;
  out.aimSpeed = speedToAimAt(height, gravity, braking);
  out.corridor =
    falling > FASTEST * out.aimSpeed + SLACK
      ? 'fast'
      : falling < SLOWEST * out.aimSpeed - SLACK
        ? 'slow'
        : 'good';
  const soon = falling + (gravity - ship.controls.thrustLevel * full) * LEAD;
  const aimSoon = speedToAimAt(height - (LEAD * (falling + soon)) / 2, gravity, braking);
  out.advice =
    soon > ADVISED.fastest * aimSoon + ADVISED.slack
      ? 'more'
      : soon < ADVISED.slowest * aimSoon - ADVISED.slack
        ? toDescend(ship.controls.thrustLevel, gravity)
        : 'hold';
}

/** With the engine off a ship falls by itself, if gravity is strong enough. */
function toDescend(throttle: number, gravity: number): 'less' | 'push' | 'hold' {
  if (throttle > 0) return 'less';
  return gravity < MIN_BRAKING ? 'push' : 'hold';
}

/** The descent speed, m/s, that a quarter of gentle braking reduces to TOUCH_SPEED over `height` m. */
function speedToAimAt(height: number, gravity: number, braking: number): number {
  const toBrake = Math.max(0, height - LAST_METRES);
  const gentle = Math.min(BRAKING_SHARE * braking, Math.max(gravity, MIN_BRAKING));
  // v² = v₀² + 2 a s
  const square = TOUCH_SPEED * TOUCH_SPEED + 2 * FLOWN_SHARE * gentle * toBrake;
  return Math.min(Math.sqrt(square), MAX_SPEED);
}
