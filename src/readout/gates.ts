import type { LoadedSettings } from '../dynamics';
import type { Surface } from './surface';

/** One condition of contact → landed (DYNAMICS, step 9): it is met while `value` is below `limit`. */
export interface Gate {
  value: number;
  limit: number;
  met: boolean;
}

/** Why a ship in contact has not landed yet. All four must be met in the same substep. */
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
}

export function createGates(): Gates {
  return { shown: false, tilt: gate(), spin: gate(), vertical: gate(), horizontal: gate() };
}

export function measureGates(out: Gates, surface: Surface, settings: LoadedSettings): void {
  const { tilt, spin, vertical, horizontal } = out;
  out.shown = true;
  tilt.value = (surface.tilt * 180) / Math.PI;
  tilt.limit = settings.contactSettleTiltDeg;
  spin.value = surface.spin;
  spin.limit = settings.contactSettleAngularVel;
  vertical.value = surface.vertical;
  vertical.limit = settings.contactSettleLinearVel;
  horizontal.value = surface.tangentialSpeed;
  horizontal.limit = settings.contactSettleLinearVel;
  judge(tilt);
  judge(spin);
  judge(vertical);
  judge(horizontal);
}

function gate(): Gate {
  // In this order: objects that begin with a `value` of any type share their layout with it, and its doubles would be boxed.
  return { met: false, value: NaN, limit: NaN };
}

function judge(gate: Gate): void {
  gate.met = gate.value < gate.limit;
}
