import { commandTorque } from './attitudeControl';
import {
  ATTITUDE_HOLD,
  ATTITUDE_MODE,
  FUEL,
  LANDED,
  MODE_NONE,
  ROTATION_INPUT,
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
  SMI_MASK,
  step,
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
import { readAxes } from '../contact/pose';
import { readPlace } from '../contact/surface';

/** Step 1: torque in body axes, thrust in ICRF, and the fuel burnt. Mass and inertia are from before the burn. */
export function actuate(): void {
  const q = quantities;
  const { ships, shipClass } = step;
  const at = step.at & SMI_MASK;
  const fuel = ships[at + FUEL]!;
  q[MASS] = shipClass[DRY_MASS]! + fuel;
  q[INERTIA_FACTOR] = shipClass[INERTIA_AT_DRY]! + shipClass[INERTIA_PER_FUEL]! * fuel;
  q[TORQUE] = 0;
  q[TORQUE + 1] = 0;
  q[TORQUE + 2] = 0;
  q[THRUST] = 0;
  q[THRUST + 1] = 0;
  q[THRUST + 2] = 0;
  q[LIFT] = 0;
  const isPushed =
    ships[at + THRUST_LEVEL] !== 0 ||
    ships[at + TRANSLATION_INPUT] !== 0 ||
    ships[at + TRANSLATION_INPUT + 1] !== 0 ||
    ships[at + TRANSLATION_INPUT + 2] !== 0;
  const isSteered =
    ships[at + ROTATION_INPUT] !== 0 ||
    ships[at + ROTATION_INPUT + 1] !== 0 ||
    ships[at + ROTATION_INPUT + 2] !== 0 ||
    ships[at + ATTITUDE_MODE] !== MODE_NONE ||
    ships[at + ATTITUDE_HOLD] === 1;
  // Most ships coast.
  if (!isPushed && !isSteered) return;
  readPlace();
  readAxes();
  q[RCS_TORQUE_SUM] = 0;
  // A landed ship is fixed to the ground, so it gets no torque and burns no fuel for attitude.
  if (isSteered && ships[at + SURFACE_STATE] !== LANDED) {
    commandTorque();
    allocateTorque();
  }
  if (ships[at + FUEL]! > 0 && (isPushed || q[RCS_TORQUE_SUM] !== 0)) applyThrust();
}

/** Divides TORQUE between reaction wheels, up to their torque and remaining momentum, and RCS, while there is fuel. */
function allocateTorque(): void {
  const q = quantities;
  const { ships, at, shipClass } = step;
  const dt = q[DT]!;
  const hasFuel = ships[at + FUEL]! > 0;
  for (let k = 0; k < 3; k++) {
    const asked = q[TORQUE + k]!;
    const momentum = ships[at + WHEEL_MOMENTUM + k]!;
    const capacity = shipClass[WHEEL_CAPACITY + k]!;
    const size = asked < 0 ? -asked : asked;
    const left = (asked < 0 ? capacity + momentum : capacity - momentum) / dt;
    const torque = shipClass[WHEEL_TORQUE + k]!;
    const wheelLimit = left < torque ? (left > 0 ? left : 0) : torque;
    const byWheel = size < wheelLimit ? size : wheelLimit;
    const wheel = asked < 0 ? -byWheel : byWheel;
    ships[at + WHEEL_MOMENTUM + k] = momentum + wheel * dt;
    if (!hasFuel) {
      q[TORQUE + k] = wheel;
      continue;
    }
    const rest = size - byWheel;
    const rcsLimit = shipClass[RCS_TORQUE + k]!;
    const byRcs = rest < rcsLimit ? rest : rcsLimit;
    q[TORQUE + k] = asked < 0 ? wheel - byRcs : wheel + byRcs;
    q[RCS_TORQUE_SUM] = q[RCS_TORQUE_SUM]! + byRcs;
  }
}

/** Fills THRUST and LIFT from main engine and translation thrusters; burns their fuel and that of the RCS torque. */
function applyThrust(): void {
  const q = quantities;
  const { ships, at, shipClass } = step;
  const fuel = ships[at + FUEL]!;
  const main = ships[at + THRUST_LEVEL]! * shipClass[MAIN_ENGINE_THRUST]!;
  const fx = ships[at + TRANSLATION_INPUT]! * shipClass[RCS_THRUST]!;
  const fy = ships[at + TRANSLATION_INPUT + 1]! * shipClass[RCS_THRUST + 1]!;
  const fz = ships[at + TRANSLATION_INPUT + 2]! * shipClass[RCS_THRUST + 2]!;
  const along = fz + main;
  const x = q[AXES]! * fx + q[AXES + 1]! * fy + q[AXES + 2]! * along;
  const y = q[AXES + 3]! * fx + q[AXES + 4]! * fy + q[AXES + 5]! * along;
  const z = q[AXES + 6]! * fx + q[AXES + 7]! * fy + q[AXES + 8]! * along;
  q[THRUST] = x;
  q[THRUST + 1] = y;
  q[THRUST + 2] = z;
  q[LIFT] = x * q[NORMAL]! + y * q[NORMAL + 1]! + z * q[NORMAL + 2]!;

  const rcs = Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + q[RCS_TORQUE_SUM]! * shipClass[FORCE_PER_TORQUE]!;
  const left = fuel - (main * shipClass[MAIN_ENGINE_FLOW]! + rcs * shipClass[RCS_FLOW]!) * q[DT]!;
  ships[at + FUEL] = left > 0 ? left : 0;
}
