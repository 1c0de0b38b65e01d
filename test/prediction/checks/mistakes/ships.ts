/** Mistakes in ships and bodies of a frame: the mistake, the expected code, and a part of the expected message. */
import { expect } from 'vitest';
import { BODIES } from '../../../../src/dynamics';
import { decodeFrameJson } from '../../../../src/wire';
import { type Mistake, frame, HEIGHT, LUNA, received, ship, thousandth, withBody, withShip } from './given';

export const SHIPS: readonly Mistake[] = [
  [
    'a vector {x, y, z}',
    'ship-unusable',
    /position/,
    () => received(withShip({ position: { x: 1, y: 2, z: 3 } })),
  ],
  ['NaN in a ship', 'ship-unusable', /velocity/, () => received(withShip({ velocity: [0, NaN, 0] }))],
  ['an unknown class', 'ship-unusable', /class/i, () => received(withShip({ shipClass: 'zeppelin' }))],
  [
    'km',
    'position-in-kilometres',
    /metres/,
    () => received(withShip({ position: thousandth(ship.position) })),
  ],
  [
    'km, nearer to another body',
    'position-in-kilometres',
    /near Luna at a thousand times/,
    () => received({ ...withShip({ position: thousandth(ship.position) }), bodies: BODIES }),
  ],
  [
    'relative km',
    'position-in-kilometres',
    /metres/,
    () =>
      received(
        withShip({ referenceBody: 'Luna', relativePosition: [1737.4, 0, 0], relativeVelocity: [0, 0, 0] }),
      ),
  ],
  [
    'km/s',
    'velocity-in-kilometres',
    /m\/s/,
    () => received(withShip({ velocity: thousandth(ship.velocity) })),
  ],
  [
    'km from the centre of a body at the origin',
    'position-in-kilometres',
    /metres/,
    () =>
      received({
        ...withShip({ position: [HEIGHT / 1000, 0, 0] }),
        bodies: [{ ...LUNA, position: [0, 0, 0], velocity: [0, 0, 0] }],
      }),
  ],
  [
    'a velocity relative to the body',
    'velocity-frame',
    /relativeVelocity/,
    () => received(withShip({ velocity: [0, 5, 0] })),
  ],
  [
    'the identity [x, y, z, w] in a list of JSON',
    'quaternion-order',
    /JSON \[w, x, y, z\]/,
    () => {
      const { attitude, ...rest } = withShip({ landedBodyName: '', surfaceContactState: '' }).ships[0]!;
      expect(attitude).toHaveLength(4);
      const decoded = decodeFrameJson({ ...frame, ships: [{ ...rest, attitude: [0, 0, 0, 1] }] });
      return received(decoded.ok ? decoded.value : null);
    },
  ],
  [
    'a relative position as ICRF',
    'ship-inside-body',
    /ICRF/,
    () => received({ ...withShip({ position: [1000, 0, 0] }), bodies: [{ ...LUNA, position: [0, 0, 0] }] }),
  ],
  [
    'degrees a second',
    'spin-in-degrees',
    /radians/,
    () => received(withShip({ angularVelocity: [0, 0, 20] })),
  ],
  [
    'attitude [w, x, y, z] of a landed ship',
    'quaternion-order',
    /\[x, y, z, w\]/,
    () =>
      received(
        withShip({
          position: [LUNA.position[0], LUNA.position[1] + HEIGHT, LUNA.position[2]],
          attitude: [Math.SQRT1_2, -Math.SQRT1_2, 0, 0],
        }),
      ),
  ],
  [
    'attitude [1, 0, 0, 0]',
    'quaternion-order',
    /\[x, y, z, w\]/,
    () => received(withShip({ attitude: [1, 0, 0, 0], landedBodyName: '', surfaceContactState: '' })),
  ],
  ['attitude in degrees', 'attitude-not-unit', /unit/, () => received(withShip({ attitude: [0, 90, 0, 0] }))],
  [
    'bodies of another tick',
    'landed-off-ground',
    /the same tick/,
    () => received(withShip({ position: [ship.position[0] + 300_000, ship.position[1], ship.position[2]] })),
  ],
  [
    'a body that was never sent',
    'body-unknown',
    /Deimos/,
    () => received(withShip({ landedBodyName: 'Deimos' })),
  ],
  ['NaN in a body', 'body-unusable', /position/, () => received(withBody({ position: [NaN, 0, 0] }))],
  [
    'a body {x, y, z}',
    'body-unusable',
    /position/,
    () => received(withBody({ position: { x: 0, y: 0, z: 0 } })),
  ],
  ['radius in km', 'body-density', /radius in m/, () => received(withBody({ radius: 1737.4 }))],
  [
    'spin of a body in degrees',
    'body-spin-in-degrees',
    /radians/,
    () => received(withBody({ angularVelocity: [0, 0, 1] })),
  ],

  [
    'a Float32Array for a vector',
    'ship-unusable',
    /a list of 3.*Float32Array/,
    () => received(withShip({ position: new Float32Array(3) })),
  ],
  [
    'strings for numbers',
    'ship-unusable',
    /position.*"1"/,
    () => received(withShip({ position: ['1', '2', '3'] })),
  ],
  [
    'angles for an attitude',
    'ship-unusable',
    /attitude.*a list of 4/,
    () => received(withShip({ attitude: [0, 90, 0] })),
  ],
  [
    'attitude {x, y, z, w}',
    'ship-unusable',
    /attitude.*\{ x, y, z, w \}/,
    () => received(withShip({ attitude: { x: 0, y: 0, z: 0, w: 1 } })),
  ],
  ['a number for a ship’s id', 'ship-unusable', /shipId.*string/, () => received(withShip({ shipId: 7 }))],
  ['no fuel', 'ship-unusable', /fuel.*undefined/, () => received(withShip({ fuel: undefined }))],
  [
    'a class as people write it',
    'ship-unusable',
    /Planetary Lander/,
    () => received(withShip({ shipClass: 'Planetary Lander' })),
  ],
  [
    'a state in capitals',
    'ship-unusable',
    /surfaceContactState.*LANDED/,
    () => received(withShip({ surfaceContactState: 'LANDED' })),
  ],
  ['a number for a ship', 'ship-unusable', /ship|object/, () => received({ ...frame, ships: [7] })],
  [
    'a quaternion of zeros',
    'attitude-not-unit',
    /unit/,
    () => received(withShip({ attitude: [0, 0, 0, 0] })),
  ],
  [
    'throttle in percent in a state',
    'state-out-of-range',
    /percent/,
    () => received(withShip({ thrustLevel: 50 })),
  ],
  ['fuel below 0', 'state-out-of-range', /kg of fuel/, () => received(withShip({ fuel: -1 }))],
  [
    'the ICRF position as the relative one',
    'relative-position',
    /centre of Luna/,
    () =>
      received(
        withShip({ referenceBody: 'Luna', relativePosition: ship.position, relativeVelocity: [0, 0, 0] }),
      ),
  ],
  [
    'axes swapped (y for z)',
    'landed-off-ground',
    /the same tick/,
    () =>
      received(withShip({ position: [ship.position[0] - HEIGHT, ship.position[2] + 3e6, ship.position[1]] })),
  ],
  [
    'a body’s attitude of zeros',
    'attitude-not-unit',
    /body Luna/,
    () => received(withBody({ attitude: [0, 0, 0, 0] })),
  ],
  [
    'a body’s mass in tonnes',
    'body-density',
    /mass in kg/,
    () => received(withBody({ mass: LUNA.mass / 1000 })),
  ],
  ['a body’s radius missing', 'body-density', /radius|mass/, () => received(withBody({ radius: undefined }))],
  ['a body by another name', 'body-unknown', /Moon/, () => received(withShip({ landedBodyName: 'Moon' }))],
];
