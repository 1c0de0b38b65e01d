import { describe, expect, it } from 'vitest';
import { BODIES, LANDING_SITE } from '../../../src/dynamics';
import { createLocalFrame } from '../../../src/scene/localFrame';
import { lookOf } from '../../../src/scene/sky/bodyLook';
import { NIGHT_ELEVATION, underSun } from '../../../src/scene/sky/underSun';

const NAMES = ['Luna', 'Earth', 'Mars', 'Phobos'];
const RADIANS = Math.PI / 180;

/** A local direction in body axes: degrees from the frame's x axis towards z, and above the horizon. */
function inBodyAxes(name: string, sun: { azimuth: number; elevation: number }, at: typeof sun): number[] {
  const body = BODIES.find((each) => each.name === name)!;
  const place = LANDING_SITE.map((value) => value * body.radius);
  const { axes } = createLocalFrame(body, place, sun);
  const level = Math.cos(at.elevation * RADIANS);
  const local = [
    level * Math.cos(at.azimuth * RADIANS),
    Math.sin(at.elevation * RADIANS),
    level * Math.sin(at.azimuth * RADIANS),
  ];
  return [0, 1, 2].map((k) => local.reduce((sum, value, row) => sum + value * axes[row * 3 + k]!, 0));
}

describe.each(NAMES)('the light over %s', (name) => {
  const look = lookOf(name);

  it('comes from the sun by day, at the given elevation', () => {
    const low = underSun(look, 5);
    expect(low.sun).toEqual({ azimuth: look.sun.azimuth, elevation: 5 });
    expect(low.trueSun).toEqual({ azimuth: 0, elevation: 5 });
    expect(low.sunStrength).toBe(look.sunStrength);
    expect(underSun(look, null).trueSun.elevation).toBe(look.sun.elevation);
  });

  it('comes at night from above the horizon, while the sun keeps its azimuth below it', () => {
    const day = underSun(look, 10);
    const night = underSun(look, NIGHT_ELEVATION);
    expect(night.isNight).toBe(true);
    expect(night.sun.elevation).toBeGreaterThan(5);
    expect(night.sunStrength).toBeLessThan(day.sunStrength / 3);
    const [dx, dy, dz] = inBodyAxes(name, day.sun, { azimuth: 0, elevation: NIGHT_ELEVATION });
    const [nx, ny, nz] = inBodyAxes(name, night.sun, night.trueSun);
    expect(Math.hypot(dx! - nx!, dy! - ny!, dz! - nz!)).toBeLessThan(1e-9);
  });

  it('comes at night from the neighbouring body, which keeps its place in the sky', () => {
    const night = underSun(look, NIGHT_ELEVATION);
    if (look.neighbour === null || night.neighbour === null) {
      expect(night.neighbour).toBe(look.neighbour);
      return;
    }
    expect(night.neighbour.azimuth).toBe(0);
    const by = inBodyAxes(name, underSun(look, null).sun, look.neighbour);
    const after = inBodyAxes(name, night.sun, night.neighbour);
    for (let k = 0; k < 3; k++) expect(after[k]).toBeCloseTo(by[k]!, 9);
  });
});

it('the neighbour’s light at night has its tint: its brightest colour is full, the others no brighter', () => {
  for (const name of NAMES) {
    const look = lookOf(name);
    const { sunColour } = underSun(look, NIGHT_ELEVATION);
    if (look.neighbour === null) continue;
    const { day, spots } = look.neighbour;
    const mixed = day.map((value, k) => (value + spots[k]!) / 2);
    const brightest = mixed.indexOf(Math.max(...mixed));
    expect(Math.max(...sunColour)).toBeCloseTo(1, 9);
    expect(sunColour[brightest]).toBeCloseTo(1, 9);
    const byTint = [0, 1, 2].sort((a, b) => mixed[a]! - mixed[b]!);
    expect([0, 1, 2].sort((a, b) => sunColour[a]! - sunColour[b]!)).toEqual(byTint);
    expect(Math.min(...sunColour)).toBeGreaterThan(0.3);
  }
});
