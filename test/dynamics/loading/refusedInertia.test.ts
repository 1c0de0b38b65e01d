import { describe, expect, it } from 'vitest';
import { loadShipClass, type ShipClass } from '../../../src/dynamics';
import { reasonOf } from './hostile';
import { LANDER } from '../provingGround';

describe('a ship class', () => {
  function refusal(given: Partial<Record<keyof ShipClass, unknown>>): string {
    return reasonOf(loadShipClass({ ...LANDER, ...given } as ShipClass));
  }

  it.each([
    [
      'singular',
      [
        [1, 1, 0],
        [1, 1, 0],
        [0, 0, 1],
      ],
      'positive definite',
    ],
    [
      'zero',
      [
        [0, 0, 0],
        [0, 0, 0],
        [0, 0, 0],
      ],
      'positive definite',
    ],
    [
      'negative',
      [
        [-1, 0, 0],
        [0, -1, 0],
        [0, 0, -1],
      ],
      'inertiaTensor[0][0]: expected > 0, as a positive definite tensor has, got -1',
    ],
    [
      'partly negative',
      [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, -3],
      ],
      'inertiaTensor[2][2]: expected > 0, as a positive definite tensor has, got -3',
    ],
    [
      'negative and skew',
      [
        [2, 1, 0],
        [0, -9, 0],
        [0, 0, 2],
      ],
      'inertiaTensor[1][1]: expected > 0',
    ],
    [
      'heavy',
      [
        [1e28, 0, 0],
        [0, 1e28, 0],
        [0, 0, 1e28],
      ],
      'inertiaTensor[0][0]: expected ≤ 1e+27 kg m²',
    ],
    [
      'needle’s',
      [
        [1e7, 0, 0],
        [0, 1e7, 0],
        [0, 0, 1],
      ],
      'expected a determinant of at least 0.000001 of its mean moment cubed',
    ],
    [
      'indefinite',
      [
        [1, 2, 0],
        [2, 1, 0],
        [0, 0, 1],
      ],
      'positive definite',
    ],
    [
      'skew',
      [
        [2, 0.5, 0],
        [-0.5, 2, 0],
        [0, 0, 2],
      ],
      'expected a symmetric tensor, got elements that differ by 1 kg m²',
    ],
    [
      'infinite',
      [
        [Infinity, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ],
      'inertiaTensor[0][0]: expected a finite number',
    ],
    [
      'short',
      [
        [1, 0, 0],
        [0, 1, 0],
      ],
      '3 rows',
    ],
    [
      'ragged',
      [
        [1, 0, 0],
        [0, 1],
        [0, 0, 1],
      ],
      'inertiaTensor[1]',
    ],
    ['missing', null, '3 rows'],
  ])('refuses a %s inertia tensor', (_, inertiaTensor, said) => {
    expect(refusal({ inertiaTensor })).toContain('inertiaTensor');
    expect(refusal({ inertiaTensor })).toContain(said);
  });

  it.each([
    ['a mast 1,000 times as long as wide', [2e5, 2e5, 1]],
    ['moments that no mass has', [1, 1, 5]],
    ['a ball', [7, 7, 7]],
  ])('accepts the tensor of %s', (_, [x, y, z]) => {
    const inertiaTensor = [
      [x, 0, 0],
      [0, y, 0],
      [0, 0, z],
    ];
    expect(refusal({ inertiaTensor })).toBe('accepted');
  });

  it('has a positive definite tensor where a Cholesky factor of it exists', () => {
    let seed = 1;
    const random = () => {
      seed = (seed * 48271) % 2147483647;
      return (2 * seed) / 2147483647 - 1;
    };
    const found = { definite: 0, indefinite: 0 };
    for (let n = 0; n < 3000; n++) {
      const [a, b, c] = [1000, 900 + 600 * random(), 900 + 600 * random()];
      const [ab, ac, bc] = [1000 * random(), 1000 * random(), 1000 * random()];
      const second = b - (ab * ab) / a;
      const below = (bc - (ab * ac) / a) / Math.sqrt(second);
      const third = c - (ac * ac) / a - below * below;
      // Close to singular, the two computations may round to different sides.
      if (Math.abs(second) < 1 || Math.abs(third) < 1) continue;
      const isDefinite = second > 0 && third > 0;
      found[isDefinite ? 'definite' : 'indefinite'] += 1;
      const inertiaTensor = [
        [a, ab, ac],
        [ab, b, bc],
        [ac, bc, c],
      ];
      expect(refusal({ inertiaTensor }), JSON.stringify(inertiaTensor)).toBe(
        isDefinite ? 'accepted' : 'ship class lander: inertiaTensor: expected a positive definite tensor',
      );
    }
    expect(Math.min(found.definite, found.indefinite)).toBeGreaterThan(300);
  });
});
