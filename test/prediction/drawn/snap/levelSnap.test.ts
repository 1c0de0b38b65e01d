import { describe, expect, it } from 'vitest';
import { BODY_ATTITUDE, BODY_STRIDE, loadShipClass, SHIP_CLASSES } from '../../../../src/dynamics';
import { createGroundedPose, hullOf, LEGS, snapToGround } from '../../../../src/prediction';
import { turnPicture } from '../../../../src/prediction/drawn/changeBody';
import { restartEase } from '../../../../src/prediction/drawn/ease';
import { createPicture } from '../../../../src/prediction/drawn/picture';
import { snapToLevel } from '../../../../src/prediction/drawn/snap/levelSnap';
import { createRandom } from '../../../../src/scenarios';
import { conjugate, rotate, times, turnAbout, unit } from '../../../dynamics/vectors';
import { value } from '../../rig';

const RADIUS = 1_737_400;

describe('level ground', () => {
  it('lifts a ship of any attitude at any place as the point-by-point snap does', () => {
    const random = createRandom(3);
    const between = (from: number, to: number) => from + (to - from) * random();
    const vector = () => [between(-1, 1), between(-1, 1), between(-1, 1)] as [number, number, number];
    const ground = { bodyName: 'Moon', radius: RADIUS, terrainHeight: () => 0 };
    let [pressed, lifted] = [0, 0];
    for (const given of SHIP_CLASSES) {
      const shipClass = value(loadShipClass(given));
      const hull = hullOf(shipClass);
      const h = shipClass.groundContactOffset;
      for (let i = 0; i < 120; i++) {
        const position = Float64Array.from(times(unit(vector()), RADIUS + h * between(0.2, 2.5)));
        // Half of them nearly upright.
        const up = unit([...position] as unknown as [number, number, number]);
        const axis = unit([-up[1], up[0], 0]);
        const upright = turnAbout(axis, Math.acos(up[2]));
        const attitude = Float64Array.from(
          i % 2 === 0 ? upright : turnAbout(unit(vector()), between(0, Math.PI)),
        );
        const pose = {
          position,
          attitude,
          grounded: i % 3 === 0,
          groundOffset: i % 4 === 0 ? between(-1, 1) : 0,
        };
        const [level, exact] = [createGroundedPose(LEGS), createGroundedPose(LEGS)];
        expect(snapToLevel(level, pose, hull, ground)).toBe(level);
        snapToGround(exact, pose, hull, ground);
        expect(level.lift).toBeCloseTo(exact.lift, 3);
        expect(level.feetHeight).toBeCloseTo(exact.feetHeight, 3);
        for (let leg = 0; leg < LEGS; leg++)
          expect(level.legCompression[leg]).toBeCloseTo(exact.legCompression[leg]!, 3);
        for (let k = 0; k < 3; k++) expect(level.position[k]).toBeCloseTo(exact.position[k]!, 3);
        if (exact.legCompression.some((x) => x > 0.01)) pressed += 1;
        if (exact.lift > 0.01) lifted += 1;
      }
    }
    expect([pressed > 20, lifted > 20]).toEqual([true, true]);
  });
});

describe('a ship that changes to another body', () => {
  const TURNS = [turnAbout(unit([1, 2, 2]), 0.7), turnAbout(unit([2, -3, 6]), -1.1)] as const;
  const bodies = new Float64Array(2 * BODY_STRIDE);
  for (const [i, turn] of TURNS.entries()) bodies.set(turn, i * BODY_STRIDE + BODY_ATTITUDE);
  const given = {
    offset: [2, -3, 6],
    rate: [1, 2, 3],
    turn: [0.1, 0.2, 0.3],
    turnRate: [0.3, -0.1, 0.2],
  } as const;
  const turned = (from: number, isActive: boolean) => {
    const picture = createPicture();
    picture.body = from;
    const { ease } = picture;
    for (const part of ['offset', 'rate', 'turn', 'turnRate'] as const) ease[part].set(given[part]);
    if (isActive) restartEase(ease);
    const before = {
      offset: [...ease.offset],
      rate: [...ease.rate],
      turn: [...ease.turn],
      turnRate: [...ease.turnRate],
    };
    turnPicture(picture, bodies, 1);
    expect(picture.body).toBe(1);
    return { ease, before };
  };

  it('keeps its drawn offset in inertial axes', () => {
    const { ease, before } = turned(0, true);
    for (const part of ['offset', 'rate', 'turn', 'turnRate'] as const) {
      const old = before[part] as [number, number, number];
      const expected = rotate(conjugate(TURNS[1]), rotate(TURNS[0], old));
      for (const [k, x] of expected.entries()) expect(ease[part][k], part).toBeCloseTo(x, 9);
    }
  });

  it('has no earlier offset if it was at no body, or had none', () => {
    expect([...turned(-1, true).ease.offset]).toEqual([2, -3, 6]);
    expect([...turned(0, false).ease.offset]).toEqual([2, -3, 6]);
  });
});
