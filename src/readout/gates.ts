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
  out.shown = true;
  judge(out.tilt, (surface.tilt * 180) / Math.PI, settings.contactSettleTiltDeg);
  judge(out.spin, surface.spin, settings.contactSettleAngularVel);
  judge(out.vertical, surface.vertical, settings.contactSettleLinearVel);
  judge(out.horizontal, surface.tangentialSpeed, settings.contactSettleLinearVel);
}

function gate(): Gate {
  return { value: 0, limit: 0, met: false };
}

function judge(out: Gate, value: number, limit: number): void {
  out.value = value;
  out.limit = limit;
  out.met = value < limit;
}
