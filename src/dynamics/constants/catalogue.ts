import type { Body, BodyMotion } from './body';
import type { Quat, Vec3 } from '../result';
import type { ShipClass } from './shipClass';

/**
 * The game's ship classes as published, and `planetary_lander`, of which the game publishes only the ground contact offset. Values
 * marked "ours" are this project's. Leg radii follow the game's arctan(leg_radius / offset) = 37°.
 */
export const SHIP_CLASSES: readonly ShipClass[] = [
  {
    name: 'fast_frigate',
    dryMass: 8000,
    fuelCapacity: 15000,
    inertiaTensor: diagonal(80000, 80000, 30000),
    dryInertiaRatio: 0.5,
    groundContactOffset: 5, // ours: the game sends it with the ship's state
    legRadius: 3.75,
    mainEngineThrust: 600000,
    mainEngineIsp: 20000,
    rcsThrust: [4000, 4000, 4000],
    rcsTorque: [8000, 8000, 8000],
    rcsLever: 1,
    rcsIsp: 3000,
    reactionWheelTorque: [500, 500, 500],
    reactionWheelCapacity: [5000, 5000, 5000],
    attitudeNaturalFrequency: 0.5,
  },
  {
    name: 'cargo_hauler',
    dryMass: 100000,
    fuelCapacity: 60000,
    inertiaTensor: diagonal(6.4e6, 6.4e6, 1.28e6),
    dryInertiaRatio: 0.625,
    groundContactOffset: 8, // ours: the game sends it with the ship's state
    legRadius: 6,
    mainEngineThrust: 400000,
    mainEngineIsp: 15000,
    rcsThrust: [10000, 10000, 10000],
    rcsTorque: [20000, 20000, 20000],
    rcsLever: 1,
    rcsIsp: 3000,
    reactionWheelTorque: [2000, 2000, 2000],
    reactionWheelCapacity: [40000, 40000, 40000],
    attitudeNaturalFrequency: 0.15,
  },
  {
    // Ours except for the offset. The class lands and lifts off from Phobos to Earth, and can be righted on the Moon.
    name: 'planetary_lander',
    dryMass: 8000,
    fuelCapacity: 8000,
    inertiaTensor: diagonal(95000, 95000, 77000), // a solid 16 t cylinder of 3.1 m radius and 6.5 m length
    dryInertiaRatio: 0.55,
    groundContactOffset: 4.56,
    legRadius: 3.42,
    mainEngineThrust: 200000, // 1.3 g on Earth at full mass
    mainEngineIsp: 340,
    rcsThrust: [4000, 4000, 4000],
    // 142 kN m about x and y with the wheels: above weight · h on the Moon (118 kN m with full tanks), below Earth's (716 kN m).
    rcsTorque: [140000, 140000, 40000],
    rcsLever: 4,
    rcsIsp: 290,
    reactionWheelTorque: [2000, 2000, 1000],
    // Saturates after 4 s of full torque, at 5°/s about x and y: enough to stay upright, not for fast turns.
    reactionWheelCapacity: [8000, 8000, 4000],
    attitudeNaturalFrequency: 1,
  },
];

function diagonal(x: number, y: number, z: number): ShipClass['inertiaTensor'] {
  return [
    [x, 0, 0],
    [0, y, 0],
    [0, 0, z],
  ];
}

const TURN = 6.283185307179586;

/**
 * Spin of a body: Ω = (2π / rotation_period) × axis, where the axis is a unit vector of the ecliptic physics frame, near +Z. The attitude
 * rotates Y, the pole, onto the axis; the direction of the prime meridian is ours.
 * @param period sidereal rotation period, s; negative for retrograde rotation
 */
function spinning(axis: Vec3, period: number): Pick<BodyMotion, 'attitude' | 'angularVelocity'> {
  const [x, y, z] = axis;
  const rate = TURN / period;
  // The shortest rotation from Y to the axis: normalize(Y × axis, 1 + Y · axis).
  const length = Math.sqrt(z * z + x * x + (1 + y) * (1 + y));
  const attitude: Quat = [z / length, 0, -x / length, (1 + y) / length];
  return { attitude, angularVelocity: [rate * x, rate * y, rate * z] };
}

/** Poles, unit vectors of the ecliptic frame at J2000: Luna tilted by 1.54° (its node is ours), Earth by 23.44°, Mars as observed. */
const LUNA_POLE: Vec3 = unit([0, 0.0269, 0.99964]);
const EARTH_POLE: Vec3 = unit([0, 0.39778, 0.91748]);
const MARS_POLE: Vec3 = unit([0.4462, -0.0555, 0.8932]);

function unit([x, y, z]: Vec3): Vec3 {
  const length = Math.sqrt(x * x + y * y + z * z);
  return [x / length, y / length, z / length];
}

/** Luna, Earth, Mars, Phobos: SI units, ICRF. Masses, mean radii and sidereal spins; positions and orbital velocities at one instant, rounded. */
export const BODIES: readonly (Body & BodyMotion)[] = [
  {
    name: 'Luna',
    mass: 7.342e22,
    radius: 1737400,
    position: [1.31e11, -7.05e10, 2.41e7],
    velocity: [14012, 26510, 11],
    ...spinning(LUNA_POLE, 2360591.5),
  },
  {
    name: 'Earth',
    mass: 5.9722e24,
    radius: 6371000,
    position: [1.3062e11, -7.02e10, 0],
    velocity: [13100, 26040, 0],
    ...spinning(EARTH_POLE, 86164.0905),
  },
  {
    name: 'Mars',
    mass: 6.4171e23,
    radius: 3389500,
    position: [-2.27e11, 5.1e10, 6.6e9],
    velocity: [-4400, -20800, -330],
    ...spinning(MARS_POLE, 88642.66),
  },
  {
    name: 'Phobos',
    mass: 1.0659e16,
    radius: 11267,
    position: [-2.269906e11, 5.1e10, 6.6e9],
    velocity: [-4400, -18662, -330],
    ...spinning(MARS_POLE, 27553.843),
  },
];
