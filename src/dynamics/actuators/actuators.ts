import { askTorque } from './attitudeControl';
import {
  FUEL,
  LANDED,
  SURFACE_STATE,
  THRUST_LEVEL,
  TRANSLATION_INPUT,
  WHEEL_MOMENTUM,
} from '../state/layout';
import {
  AXES,
  DT,
  INERTIA_FACTOR,
  LIFT,
  MASS,
  NORMAL,
  quantities,
  RCS_TORQUE_SUM,
  start,
  type Step,
  THRUST,
  TORQUE,
} from '../contact/quantities';
import {
  DRY_MASS,
  FORCE_PER_TORQUE,
  INERTIA_AT_DRY,
  INERTIA_PER_FUEL,
  MAIN_ENGINE_FLOW,
  MAIN_ENGINE_THRUST,
  RCS_FLOW,
  RCS_THRUST,
  RCS_TORQUE,
  WHEEL_CAPACITY,
  WHEEL_TORQUE,
} from '../constants/constantRows';

/** Step 1: torque in body axes, thrust in ICRF, and the fuel burnt. Mass and inertia are from before the burn. */
export function actuate(step: Step): void {
  const q = quantities;
  const { shipClass } = step;
  const fuel = q[FUEL]!;
  q[MASS] = shipClass[DRY_MASS]! + fuel;
  q[INERTIA_FACTOR] = shipClass[INERTIA_AT_DRY]! + shipClass[INERTIA_PER_FUEL]! * fuel;
  q[TORQUE] = 0;
  q[TORQUE + 1] = 0;
  q[TORQUE + 2] = 0;
  q[RCS_TORQUE_SUM] = 0;
  // A landed ship is fixed to the ground, so it gets no torque and burns no fuel for attitude.
  if (q[SURFACE_STATE] !== LANDED && askTorque(step)) giveTorque(step);
  push(step);
  q[LIFT] =
    q[THRUST]! * start[NORMAL]! + q[THRUST + 1]! * start[NORMAL + 1]! + q[THRUST + 2]! * start[NORMAL + 2]!;
}

/** Divides TORQUE between reaction wheels, up to their torque and remaining momentum, and RCS, while there is fuel. */
function giveTorque(step: Step): void {
  const q = quantities;
  const { shipClass } = step;
  const dt = q[DT]!;
  const hasFuel = q[FUEL]! > 0;
  for (let k = 0; k < 3; k++) {
    const asked = q[TORQUE + k]!;
    const momentum = q[WHEEL_MOMENTUM + k]!;
    const capacity = shipClass[WHEEL_CAPACITY + k]!;
    const size = asked < 0 ? -asked : asked;
    const left = (asked < 0 ? capacity + momentum : capacity - momentum) / dt;
    const torque = shipClass[WHEEL_TORQUE + k]!;
    const mostByWheel = left < torque ? (left > 0 ? left : 0) : torque;
    const byWheel = size < mostByWheel ? size : mostByWheel;
    const wheel = asked < 0 ? -byWheel : byWheel;
    q[WHEEL_MOMENTUM + k] = momentum + wheel * dt;
    if (!hasFuel) {
      q[TORQUE + k] = wheel;
      continue;
    }
    const rest = size - byWheel;
    const mostByRcs = shipClass[RCS_TORQUE + k]!;
    const byRcs = rest < mostByRcs ? rest : mostByRcs;
    q[TORQUE + k] = asked < 0 ? wheel - byRcs : wheel + byRcs;
    q[RCS_TORQUE_SUM] = q[RCS_TORQUE_SUM]! + byRcs;
  }
}

/** Fills THRUST from main engine and translation thrusters; burns their fuel and that of the RCS torque. */
function push(step: Step): void {
  const q = quantities;
  const { shipClass } = step;
  q[THRUST] = 0;
  q[THRUST + 1] = 0;
  q[THRUST + 2] = 0;
  const fuel = q[FUEL]!;
  if (!(fuel > 0) || !(commandsThrust() || q[RCS_TORQUE_SUM] !== 0)) return;
  const main = q[THRUST_LEVEL]! * shipClass[MAIN_ENGINE_THRUST]!;
  const fx = q[TRANSLATION_INPUT]! * shipClass[RCS_THRUST]!;
  const fy = q[TRANSLATION_INPUT + 1]! * shipClass[RCS_THRUST + 1]!;
  const fz = q[TRANSLATION_INPUT + 2]! * shipClass[RCS_THRUST + 2]!;
  const along = fz + main;
  q[THRUST] = q[AXES]! * fx + q[AXES + 1]! * fy + q[AXES + 2]! * along;
  q[THRUST + 1] = q[AXES + 3]! * fx + q[AXES + 4]! * fy + q[AXES + 5]! * along;
  q[THRUST + 2] = q[AXES + 6]! * fx + q[AXES + 7]! * fy + q[AXES + 8]! * along;

  const rcs = Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + q[RCS_TORQUE_SUM]! * shipClass[FORCE_PER_TORQUE]!;
  const left = fuel - (main * shipClass[MAIN_ENGINE_FLOW]! + rcs * shipClass[RCS_FLOW]!) * q[DT]!;
  q[FUEL] = left > 0 ? left : 0;
}

/** Whether main engine or translation thrusters are commanded. Most ships coast. */
export function commandsThrust(): boolean {
  const q = quantities;
  return (
    q[THRUST_LEVEL] !== 0 ||
    q[TRANSLATION_INPUT] !== 0 ||
    q[TRANSLATION_INPUT + 1] !== 0 ||
    q[TRANSLATION_INPUT + 2] !== 0
  );
}
