import type { BodyState } from '../../../wire';
import type { Warn } from '../../warnings';

/** kg/m³: a comet is denser than the first, and a planet far below the second. */
const MIN_DENSITY = 50;
const MAX_DENSITY = 50_000;
/** rad/s: one turn in two minutes, faster than any body held together by gravity. */
const MAX_SPIN = 0.05;

/** Warns of implausible bodies: a vector that is not a list or not finite, km for metres, degrees for radians. */
export function checkBodies(warn: Warn, bodies: readonly BodyState[]): void {
  for (const body of bodies as readonly unknown[])
    if (typeof body === 'object' && body !== null) checkBody(warn, body as BodyState);
}

function checkBody(warn: Warn, body: BodyState): void {
  const { name, mass, radius } = body;
  for (const [field, count] of [
    ['position', 3],
    ['velocity', 3],
    ['attitude', 4],
    ['angularVelocity', 3],
  ] as const) {
    const value: unknown = body[field];
    if (value === undefined || value === null || areNumbers(value, count)) continue;
    const message = `${field} of body ${name}: expected a list of ${count} finite numbers. Decode the frame with decodeFrameJson.`;
    warn('body-unusable', message, { body: name, field, value });
    return;
  }
  const attitude = (body as Partial<BodyState>).attitude ?? [1];
  if (Math.abs(Math.hypot(...attitude) - 1) > 1e-3)
    warn(
      'attitude-not-unit',
      `The attitude of body ${name} has length ${Math.hypot(...attitude)}: expected a unit quaternion [x, y, z, w].`,
      {
        field: `body ${name}`,
        value: attitude,
      },
    );
  const density = mass / ((4 / 3) * Math.PI * radius ** 3);
  if (!(density >= MIN_DENSITY && density <= MAX_DENSITY))
    warn('body-density', `Body ${name} weighs ${density} kg/m³: mass in kg, radius in m (not km)?`, {
      body: name,
      mass,
      radius,
    });
  const spin = Math.hypot(...((body as Partial<BodyState>).angularVelocity ?? [0]));
  if (spin > MAX_SPIN)
    warn('body-spin-in-degrees', `Body ${name} turns by ${spin} rad/s: pass radians, not degrees.`, {
      body: name,
      value: body.angularVelocity,
    });
}

function areNumbers(value: unknown, count: number): boolean {
  return Array.isArray(value) && value.length === count && value.every(Number.isFinite);
}
