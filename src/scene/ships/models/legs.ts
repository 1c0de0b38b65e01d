import { FINISHES, type Finish, type Parts } from './parts';
import { addStrut, tube, turned } from './shapes';
import type { Stance } from '../shipModel';

/** How a class's four legs are made; feet at azimuths 45°, 135°, 225°, 315°, where prediction's hull has them. */
export interface LegStyle {
  /** Where the main strut leaves the hull: distance from the axis and z, m. */
  readonly hip: readonly [number, number];
  /** Where the braces leave it, and how far they spread, rad. */
  readonly brace: readonly [number, number];
  readonly spread: number;
  readonly thickness: number;
  readonly padRadius: number;
  readonly finish: Finish;
}

/** Struts whose inner tube slides into the outer one as the foot comes up; pads whose underside is the foot of the law. */
export function addLegs(parts: Parts, { h, legRadius }: Stance, style: LegStyle): void {
  const { hip, brace, thickness, padRadius, finish } = style;
  for (let leg = 0; leg < 4; leg++) {
    const azimuth = ((leg + 0.5) * Math.PI) / 2;
    const at = (radius: number, z: number, turn = 0): [number, number, number] => [
      radius * Math.cos(azimuth + turn),
      radius * Math.sin(azimuth + turn),
      z,
    ];
    const whole = { leg, low: 1, high: 1 };
    const ankleZ = -h + padRadius * 0.5;
    const kneeShare = 0.55;
    const knee = at(hip[0] + (legRadius - hip[0]) * kneeShare, hip[1] + (ankleZ - hip[1]) * kneeShare);
    const inside = at(hip[0] + (legRadius - hip[0]) * 0.4, hip[1] + (ankleZ - hip[1]) * 0.4);
    const ankle = at(legRadius, ankleZ);
    addStrut(parts, finish, { from: at(...hip), to: knee, radius: thickness });
    addStrut(parts, FINISHES.silver, {
      from: ankle,
      to: inside,
      radius: thickness * 0.62,
      flex: { leg, low: 1, high: 0 },
    });
    for (const turn of [-style.spread, style.spread]) {
      addStrut(parts, FINISHES.grey, {
        from: at(...brace, turn),
        to: at(legRadius * 0.985, ankleZ + padRadius * 0.35),
        radius: thickness * 0.48,
        flex: { leg, low: 0, high: 1 },
      });
    }
    parts.add(tube(thickness * 1.3, thickness * 1.3, thickness * 1.6, 10), FINISHES.grey, { at: knee });
    // A shallow dish: flat underside at the foot's height.
    parts.add(
      turned([
        [0, 0],
        [padRadius * 0.86, 0],
        [padRadius, padRadius * 0.16],
        [padRadius * 0.9, padRadius * 0.2],
        [padRadius * 0.25, padRadius * 0.24],
        [0, padRadius * 0.6],
      ]),
      FINISHES.foil,
      { at: at(legRadius, -h), flex: whole },
    );
  }
}
