import type { DesignShip } from './law';
import { conjugate, plus, times, turned, turnOn, type Vec, zero } from './vectors';

/** What the pilot's controls do to a ship of the design: thrust, fuel and rotation. */

const G0 = 9.80665;

export function massOf({ shipClass, fuel }: DesignShip): number {
  return shipClass.dryMass + fuel;
}

export function thrustOf({ shipClass, controls, fuel, attitude }: DesignShip): Vec {
  if (fuel <= 0) return zero();
  const { translationInput: t, thrustLevel } = controls;
  const { rcsThrust: rcs, mainEngineThrust } = shipClass;
  return turned(attitude, [t[0] * rcs[0], t[1] * rcs[1], t[2] * rcs[2] + thrustLevel * mainEngineThrust]);
}

export function burn(ship: DesignShip, dt: number): void {
  const { mainEngineThrust, mainEngineIsp } = ship.shipClass;
  ship.fuel = Math.max(
    0,
    ship.fuel - ((ship.controls.thrustLevel * mainEngineThrust) / (mainEngineIsp * G0)) * dt,
  );
}

/** The stick, or the controller's damping, and an outer torque (ICRF), by the inertia tensor's diagonal. */
export function turnShip(ship: DesignShip, torque: Vec, dt: number): void {
  const { shipClass, controls } = ship;
  const back = conjugate(ship.attitude);
  const spin = turned(back, ship.angularVelocity);
  const outer = turned(back, torque);
  const ratio = shipClass.dryInertiaRatio ?? 1;
  const factor = ratio + ((1 - ratio) * ship.fuel) / shipClass.fuelCapacity;
  const alpha = [0, 1, 2].map((k) => {
    const inertia = shipClass.inertiaTensor[k]![k]! * factor;
    const most = shipClass.rcsTorque[k]! + shipClass.reactionWheelTorque[k]!;
    const stick = controls.rotationInput[k]!;
    const damping = controls.attitudeHold ? -2 * shipClass.attitudeNaturalFrequency * spin[k]! * inertia : 0;
    const asked = stick === 0 ? Math.max(-most, Math.min(most, damping)) : stick * most;
    return (asked + outer[k]!) / inertia;
  }) as Vec;
  ship.angularVelocity = plus(ship.angularVelocity, times(turned(ship.attitude, alpha), dt));
  ship.attitude = turnOn(ship.attitude, ship.angularVelocity, dt);
}
