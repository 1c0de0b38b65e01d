/** The scene's axes, and its sun. */
import { type DirectionalLight, type HemisphereLight, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { BODIES, type Quat } from '../../src/dynamics';
import {
  createLocalFrame,
  createTurn,
  rotate,
  toBodyAxes,
  toLocalPoint,
  turnOfFrame,
  writeScreenAxes,
} from '../../src/scene/localFrame';
import { lookOf } from '../../src/scene/sky/bodyLook';
import { createSunlight } from '../../src/scene/sky/sunlight';
import { NORMAL } from '../readout/views';

const LUNA = BODIES.find(({ name }) => name === 'Luna')!;
const near = (values: Iterable<number>, digits = 9) =>
  [...values].map((value): unknown => expect.closeTo(value, digits));
const POLE = new Vector3(0, 1, 0);

describe('the axes of the scene', () => {
  it.each([
    [[0.36, 0.48, 0.8], 60, 15],
    [[-0.6, -0.3, 0.2], 200, -8],
    [[0, 0, -2], 0, 30],
    [[1, 0, 0], 90, 1],
  ])('over %o have x towards a sun %d° from east, %d° high', (point, azimuth, elevation) => {
    const { axes, sunSlope, radius, bodyName } = createLocalFrame(LUNA, point, { azimuth, elevation });
    const up = new Vector3(...point).normalize();
    const east = POLE.clone().cross(up).normalize();
    const north = up.clone().cross(east);
    const angle = (azimuth * Math.PI) / 180;
    const x = east.clone().multiplyScalar(Math.cos(angle)).addScaledVector(north, Math.sin(angle));
    expect([...axes]).toEqual(near([...x, ...up, ...x.clone().cross(up)]));
    expect([sunSlope, radius, bodyName]).toEqual([
      expect.closeTo(Math.tan((elevation * Math.PI) / 180), 9),
      LUNA.radius,
      'Luna',
    ]);
  });

  it('exist over the poles', () => {
    for (const y of [1, -1]) {
      const { axes } = createLocalFrame(LUNA, [0, y, 0], { azimuth: 30, elevation: 10 });
      const [x, up, z] = [0, 3, 6].map((at) => new Vector3(...axes.subarray(at, at + 3)));
      expect([...up!]).toEqual(near([0, y, 0]));
      expect([x!.length(), x!.dot(up!), ...x!.clone().cross(up!).sub(z!)]).toEqual(near([1, 0, 0, 0, 0]));
    }
  });

  const attitude = new Quaternion().setFromAxisAngle(new Vector3(1, 2, -2).normalize(), 0.7);
  const frame = createLocalFrame(LUNA, NORMAL, { azimuth: 60, elevation: 15 });
  const given = attitude.toArray() as unknown as Quat;
  const turn = turnOfFrame(createTurn(), frame, given);

  it('turn with the body', () => {
    const inBody = new Vector3(0.3, -0.5, 0.9);
    const inIcrf = inBody.clone().applyQuaternion(attitude);
    const local = rotate(new Float64Array(3), frame.axes, inBody.toArray());
    expect([...rotate(new Float64Array(3), turn.matrix, inIcrf.toArray())]).toEqual(near(local));
    const quaternion = new Quaternion(...turn.quaternion);
    expect([...inIcrf.clone().applyQuaternion(quaternion)]).toEqual(near(local));
    expect(quaternion.length()).toBeCloseTo(1, 12);
    const out = new Float64Array(3);
    toBodyAxes(out, given, Float64Array.from(inIcrf));
    expect([...out]).toEqual(near(inBody));
    const surface = inIcrf.clone().multiplyScalar(LUNA.radius);
    const above = [...local].map((value) => value * LUNA.radius);
    expect([...toLocalPoint(new Float64Array(3), frame, turn, surface.toArray())]).toEqual(
      near([above[0]!, above[1]! - LUNA.radius, above[2]!], 3),
    );
  });

  it('give right, away and up as an eye sees them', () => {
    const out = new Float64Array(9);
    writeScreenAxes(out, turn, Float64Array.of(1, 10, 2), Float64Array.of(4, 0, 6));
    const local = [0, 3, 6].map((at) => [
      ...rotate(new Float64Array(3), turn.matrix, out.subarray(at, at + 3)),
    ]);
    expect(local).toEqual([near([-0.8, 0, 0.6]), near([0.6, 0, 0.8]), near([0, 1, 0])]);
  });
});

describe('the sun', () => {
  const frame = createLocalFrame(LUNA, NORMAL, { azimuth: 60, elevation: 20 });
  const look = lookOf('Mars');
  function createSun() {
    const light = createSunlight();
    light.paint(look, frame);
    const [sun, , around] = light.group.children as [DirectionalLight, unknown, HemisphereLight];
    return { light, sun, around };
  }

  it('has the look’s colours, and light from sky and ground around', () => {
    const { sun, around, light } = createSun();
    const slope = Math.tan(Math.PI / 9);
    expect([...light.direction]).toEqual(near(new Vector3(1, slope, 0).normalize()));
    expect([...sun.color]).toEqual(near(look.sunColour));
    expect(sun.intensity).toBeCloseTo(look.sunStrength * Math.PI * 0.62, 9);
    expect([...around.color]).toEqual(near(look.fill.map((part) => 3 * part)));
    const bounced = look.fill.map((part, k) => part + look.dust[k]! * 0.2 * look.sunStrength);
    expect([...around.groundColor]).toEqual(near(bounced));
    expect(sun.castShadow).toBe(true);
  });

  it('opens the camera in the dark, at once in a new world and then as an eye adapts', () => {
    const { light, around } = createSun();
    expect(light.shade(0, 0.016)).toBeCloseTo(2.7, 9);
    expect(around.intensity).toBeCloseTo(Math.PI * 0.35, 9);
    expect(light.shade(1, 0.5)).toBeCloseTo(1 + 1.7 * Math.exp(-0.75), 9);
    expect(around.intensity).toBeCloseTo(Math.PI * 0.9, 9);
    expect(light.shade(1, 5)).toBeCloseTo(1 + 1.7 * Math.exp(-8.25), 9);
    // The rest of the way is not seen: it arrives.
    expect(light.shade(1, 0.01)).toBe(1);
    expect(light.shade(0.5, 0)).toBeCloseTo(1, 9);
    light.adapt();
    expect(light.shade(0.5, 0)).toBeCloseTo(1.85, 9);
  });

  it('has its shadow map over the ship, its grid fixed in the ground', () => {
    const { sun, light } = createSun();
    const { direction } = light;
    const side = new Vector3(0, 0, 1);
    const over = direction.clone().cross(side).normalize();
    const [reach, depth] = [20, 7];
    const texel = (2 * reach) / 1024;
    for (const shift of [0, 0.013, 0.3]) {
      const place = new Vector3(5 + shift, 3 - shift, 8 + 2 * shift);
      const eye = new Vector3(1, 2, 30);
      light.follow(Float64Array.from(place), Float64Array.from(eye), reach, depth);
      const target = sun.target.position.clone().add(eye);
      expect(target.distanceTo(place)).toBeLessThan(texel);
      for (const axis of [side, over]) {
        const steps = target.dot(axis) / texel;
        expect(Math.abs(steps - Math.round(steps))).toBeLessThan(1e-6);
      }
      expect([...sun.position]).toEqual(
        near(sun.target.position.clone().addScaledVector(direction, 2 * reach)),
      );
    }
    const { left, right, top, bottom, near: from, far } = sun.shadow.camera;
    expect([left, right, top, bottom, from, far]).toEqual([-20, 20, 20, -20, 0, 47]);
  });
});
