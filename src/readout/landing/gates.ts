import type { LoadedSettings } from '../../dynamics';
import type { Surface } from '../surface';

/** One condition of contact → landed (DYNAMICS, step 9): it is met while `value` is below `limit`. */
export interface Gate {
  value: number;
  limit: number;
  met: boolean;
}

/** Why a ship in contact has not landed yet. All must be met in the same substep. */
export interface Gates {
  /** While in contact. */
  shown: boolean;
  /** Degrees. */
  readonly tilt: Gate;
  /** ‖w_rel‖, rad/s. */
  readonly spin: Gate;
  /** The law's `vertical`: speed with the legs' stored energy, m/s. */
  readonly vertical: Gate;
  /** ‖v_tangential‖, m/s. */
  readonly horizontal: Gate;
  /** Whether the ground slopes: only then are the two below meaningful. */
  onSlope: boolean;
  /** Slope, degrees, against arctan mu_static: above that the ship slides. */
  readonly slope: Gate;
  /** Lean from the vertical, degrees, against arctan(leg_radius / h): above that its weight is outside its feet. */
  readonly balance: Gate;
}

/** rad: ground that slopes less than a degree is level to a pilot. */
const LEVEL = 0.0175;

export function createGates(): Gates {
  return {
    shown: false,
    tilt: gate(),
    spin: gate(),
    vertical: gate(),
    horizontal: gate(),
    onSlope: false,
    slope: gate(),
    balance: gate(),
  };
}

export function measureGates(out: Gates, surface: Surface, settings: LoadedSettings): void {
  const { tilt, spin, vertical, horizontal, slope, balance } = out;
  out.shown = true;
  tilt.value = (surface.tilt * 180) / Math.PI;
  tilt.limit = settings.contactSettleTiltDeg;
  spin.value = surface.spin;
  spin.limit = settings.contactSettleAngularVel;
  vertical.value = surface.vertical;
  vertical.limit = settings.contactSettleLinearVel;
  horizontal.value = surface.slideSpeed;
  horizontal.limit = settings.contactSettleLinearVel;
  judge(tilt);
  judge(spin);
  judge(vertical);
  judge(horizontal);
  out.onSlope = surface.slope > LEVEL;
  slope.value = (surface.slope * 180) / Math.PI;
  slope.limit = (Math.atan(settings.contactFrictionStatic) * 180) / Math.PI;
  balance.value = (surface.lean * 180) / Math.PI;
  balance.limit = (surface.noReturn * 180) / Math.PI;
  slope.met = slope.value <= slope.limit;
  balance.met = balance.value <= balance.limit;
}

function gate(): Gate {
  // In this order: objects that begin with a `value` of any type share their layout with it, and its doubles would be boxed.
  return { met: false, value: NaN, limit: NaN };
}

function judge(gate: Gate): void {
  gate.met = gate.value < gate.limit;
}
