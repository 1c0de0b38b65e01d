import type { ShipGeometries } from './models/parts';

type Point = readonly [number, number, number];

/** A ship to draw, in body axes, m. */
export interface ShipModel extends ShipGeometries {
  /** Mouths of the main engine's bells; they blow along −z. */
  readonly engines: readonly Engine[];
  readonly thrusters: readonly Thruster[];
}

export interface Engine {
  readonly at: Point;
  readonly radius: number;
}

export interface Thruster {
  readonly at: Point;
  /** Direction of its gas; the ship is pushed the other way. */
  readonly blows: Point;
}

/** The dimensions that a model is built to: height of the centre of mass over the feet and radius of the feet, m. */
export interface Stance {
  readonly h: number;
  readonly legRadius: number;
}

/** Four clusters of four nozzles at `radius` and height `z`: up, down and both ways around. */
export function thrusterClusters(radius: number, z: number, firstAngle: number): Thruster[] {
  return [0, 1, 2, 3].flatMap((n) => {
    const angle = firstAngle + (n * Math.PI) / 2;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const at = (r: number, dz: number): Point => [cos * r, sin * r, z + dz];
    return [
      { at: at(radius, 0.22), blows: [0, 0, 1] as const },
      { at: at(radius, -0.22), blows: [0, 0, -1] as const },
      { at: at(radius, 0), blows: [-sin, cos, 0] as const },
      { at: at(radius, 0), blows: [sin, -cos, 0] as const },
    ];
  });
}
