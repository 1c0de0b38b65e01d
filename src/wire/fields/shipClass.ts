import { loadShipClass, type Mat3, type ShipClass } from '../../dynamics';
import type { galaxy } from '../generated/codec.js';
import { CLASS_FIGURE } from '../limits';
import { refuseLoaded } from '../loaders';
import { type Fields, messageIn, nameIn, numberIn, type Reading, valueIn } from './reading';
import { optionalVectorIn, vectorFields, vectorIn } from './vectors';

/** A ship class, checked as in DYNAMICS, Ranges. */
export function readShipClass(r: Reading, from: Fields): ShipClass {
  const shipClass: ShipClass = {
    name: nameIn(r, from, 'name'),
    dryMass: numberIn(r, from, 'dry_mass', CLASS_FIGURE),
    fuelCapacity: numberIn(r, from, 'fuel_capacity', CLASS_FIGURE),
    inertiaTensor: tensorIn(r, from, 'inertia_tensor'),
    groundContactOffset: numberIn(r, from, 'ground_contact_offset', CLASS_FIGURE),
    legRadius: numberIn(r, from, 'leg_radius', CLASS_FIGURE),
    mainEngineThrust: numberIn(r, from, 'main_engine_thrust', CLASS_FIGURE),
    mainEngineIsp: numberIn(r, from, 'main_engine_isp', CLASS_FIGURE),
    rcsThrust: vectorIn(r, from, 'rcs_thrust', CLASS_FIGURE),
    rcsTorque: vectorIn(r, from, 'rcs_torque', CLASS_FIGURE),
    rcsLever: numberIn(r, from, 'rcs_lever', CLASS_FIGURE),
    rcsIsp: numberIn(r, from, 'rcs_isp', CLASS_FIGURE),
    reactionWheelTorque: vectorIn(r, from, 'reaction_wheel_torque', CLASS_FIGURE),
    reactionWheelCapacity: optionalVectorIn(r, from, 'reaction_wheel_capacity', CLASS_FIGURE),
    attitudeNaturalFrequency: numberIn(r, from, 'attitude_natural_frequency', CLASS_FIGURE),
    dryInertiaRatio:
      valueIn(r, from, 'dry_inertia_ratio') === undefined
        ? null
        : numberIn(r, from, 'dry_inertia_ratio', CLASS_FIGURE),
  };
  refuseLoaded(r, loadShipClass(shipClass), `ship class ${shipClass.name}: `);
  return shipClass;
}

/** Rows under x, y and z; in JSON also a list of three rows. */
function tensorIn(r: Reading, from: Fields, name: string): Mat3 {
  const value = valueIn(r, from, name);
  if (r.source === 'protobuf' || !Array.isArray(value) || value.length !== 3)
    return messageIn(r, from, name, readTensor);
  const [x, y, z] = value as unknown[];
  return messageIn(r, { [name]: { x, y, z } }, name, readTensor);
}

function readTensor(r: Reading, from: Fields): Mat3 {
  return [
    vectorIn(r, from, 'x', CLASS_FIGURE),
    vectorIn(r, from, 'y', CLASS_FIGURE),
    vectorIn(r, from, 'z', CLASS_FIGURE),
  ];
}

export function shipClassFields(c: ShipClass): galaxy.stream.ShipClass.$Properties {
  const [x, y, z] = c.inertiaTensor;
  return {
    name: c.name,
    dry_mass: c.dryMass,
    fuel_capacity: c.fuelCapacity,
    inertia_tensor: { x: vectorFields(x), y: vectorFields(y), z: vectorFields(z) },
    ground_contact_offset: c.groundContactOffset,
    leg_radius: c.legRadius,
    main_engine_thrust: c.mainEngineThrust,
    main_engine_isp: c.mainEngineIsp,
    rcs_thrust: vectorFields(c.rcsThrust),
    rcs_torque: vectorFields(c.rcsTorque),
    rcs_lever: c.rcsLever,
    rcs_isp: c.rcsIsp,
    reaction_wheel_torque: vectorFields(c.reactionWheelTorque),
    ...(c.reactionWheelCapacity !== null && {
      reaction_wheel_capacity: vectorFields(c.reactionWheelCapacity),
    }),
    attitude_natural_frequency: c.attitudeNaturalFrequency,
    ...(c.dryInertiaRatio !== null && { dry_inertia_ratio: c.dryInertiaRatio }),
  };
}
