import type { Body, BodyMotion } from './body';
import type { ShipClass } from './shipClass';

/**
 * The game's ship classes. Published by the game: fast_frigate's dry mass and RCS torque; cargo_hauler's dry mass, fuel, main
 * engine and RCS torque; planetary_lander's ground contact offset. Everything marked "assumed" is ours.
 */
export const SHIP_CLASSES: readonly ShipClass[] = [
  {
    name: 'fast_frigate',
    dryMass: 8000,
    fuelCapacity: 6000, // assumed
    inertiaTensor: [
      // assumed: a solid 14 t cylinder of 2.2 m radius and 11 m length, its tanks a little off the axis
      [158000, 1200, -900],
      [1200, 158000, 700],
      [-900, 700, 34000],
    ],
    groundContactOffset: 5, // assumed
    legRadius: 3.75, // assumed: 0.75 h
    mainEngineThrust: 160000, // assumed: 1.2 g on Earth at full mass
    mainEngineIsp: 3000, // assumed
    rcsThrust: [3000, 3000, 3000], // assumed
    rcsTorque: [8000, 8000, 8000],
    rcsLever: 4, // assumed
    rcsIsp: 300, // assumed
    reactionWheelTorque: [1500, 1500, 800], // assumed
  },
  {
    name: 'cargo_hauler',
    dryMass: 100000,
    fuelCapacity: 60000,
    inertiaTensor: [
      // assumed: a solid 160 t box of 13 × 13 × 16 m, its cargo not quite even. As round as this, since the law caps the length of
      // the legs' whole moment: moments about x and y that differ by an eighth turned it aside, and the ship toppled 0.2° early
      [5.69e6, 2e4, 2e4],
      [2e4, 5.64e6, -3e4],
      [2e4, -3e4, 4.51e6],
    ],
    groundContactOffset: 8, // assumed
    legRadius: 6, // assumed: 0.75 h
    mainEngineThrust: 400000,
    mainEngineIsp: 15000,
    rcsThrust: [12000, 12000, 12000], // assumed
    rcsTorque: [20000, 20000, 20000],
    rcsLever: 7, // assumed
    rcsIsp: 300, // assumed
    reactionWheelTorque: [4000, 4000, 4000], // assumed
  },
  {
    name: 'planetary_lander',
    dryMass: 8000, // assumed
    fuelCapacity: 8000, // assumed
    inertiaTensor: [
      // assumed: a solid 16 t cylinder of 3.1 m radius and 6.5 m length
      [95000, 0, 0],
      [0, 95000, 0],
      [0, 0, 77000],
    ],
    groundContactOffset: 4.56,
    legRadius: 3.42, // assumed: 0.75 h
    mainEngineThrust: 200000, // assumed: 1.3 g on Earth at full mass
    mainEngineIsp: 340, // assumed
    rcsThrust: [4000, 4000, 4000], // assumed
    // assumed: with the wheels 142 kN m about x and y, above weight · h on the Moon (118 kN m full) and below Earth's (716)
    rcsTorque: [140000, 140000, 40000],
    rcsLever: 4, // assumed
    rcsIsp: 290, // assumed
    reactionWheelTorque: [2000, 2000, 1000], // assumed
  },
];

/** The bodies one can land on: J2000 masses, mean radii and sidereal spins; places and orbital speeds of one instant, rounded. */
export const BODIES: readonly (Body & BodyMotion)[] = [
  {
    name: 'Moon',
    mass: 7.342e22,
    radius: 1737400,
    position: [1.31e11, -7.05e10, 2.41e7],
    velocity: [14012, 26510, 11],
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, 2.6617e-6, 0],
  },
  {
    name: 'Earth',
    mass: 5.9722e24,
    radius: 6371000,
    position: [1.3062e11, -7.02e10, 0],
    velocity: [13100, 26040, 0],
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, 7.2921e-5, 0],
  },
  {
    name: 'Mars',
    mass: 6.4171e23,
    radius: 3389500,
    position: [-2.27e11, 5.1e10, 6.6e9],
    velocity: [-4400, -20800, -330],
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, 7.0882e-5, 0],
  },
  {
    name: 'Phobos',
    mass: 1.0659e16,
    radius: 11267,
    position: [-2.269906e11, 5.1e10, 6.6e9],
    velocity: [-4400, -18662, -330],
    attitude: [0, 0, 0, 1],
    angularVelocity: [0, 2.2802e-4, 0],
  },
];
