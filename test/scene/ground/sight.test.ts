import { Frustum, Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { BODIES, LANDING_SITE, TERRAINS } from '../../../src/dynamics';
import { createRandom } from '../../../src/scenarios';
import { visibleRange, writeSectors } from '../../../src/scene/ground/groundSectors';
import { isOverHorizon } from '../../../src/scene/sky/horizon';
import { createLocalFrame, type LocalFrame } from '../../../src/scene/localFrame';
import { CELLS } from '../../../src/scene/ground/levels';
import { cornerFor, layOutLevel, moveLevel, type TerrainLevel } from '../../../src/scene/ground/terrainLevel';
import { aimCone, coneMeets, createCone, type ViewCone } from '../../../src/scene/camera/viewCone';
import { ownLevel, ownSectors } from './ownLevel';

const hills = TERRAINS['hills']!;
const SUN = { elevation: 13, azimuth: 58 };

function frameOn(bodyName: string): LocalFrame {
  const body = BODIES.find(({ name }) => name === bodyName)!;
  const place = LANDING_SITE.map((value) => value * body.radius);
  return createLocalFrame(body, place, SUN);
}

function levelOf(frame: LocalFrame, spacing: number, x: number, z: number): TerrainLevel {
  const level = ownLevel(spacing);
  moveLevel(level, [cornerFor(level, x), cornerFor(level, z)], frame, hills);
  layOutLevel(level);
  return level;
}

/** An eye `distance` m from a focus near the ground, and three's frustum from there. */
function eyeAt(rng: () => number, distance: number) {
  const focus = Float64Array.of(rng() * 200 - 100, 3 + rng() * 60, rng() * 200 - 100);
  const [azimuth, elevation] = [rng() * 2 * Math.PI, rng() * 1.7 - 0.2];
  const eye = Float64Array.of(
    focus[0]! + distance * Math.cos(elevation) * Math.cos(azimuth),
    focus[1]! + distance * Math.sin(elevation),
    focus[2]! + distance * Math.cos(elevation) * Math.sin(azimuth),
  );
  const camera = new PerspectiveCamera(48, rng() < 0.5 ? 16 / 9 : 9 / 16, 0.1, 1e6);
  camera.position.set(eye[0]!, eye[1]!, eye[2]);
  camera.lookAt(focus[0]!, focus[1]!, focus[2]!);
  camera.updateMatrixWorld();
  const seen = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const frustum = new Frustum().setFromProjectionMatrix(seen);
  const cone = createCone();
  const upright = Math.tan((camera.fov * Math.PI) / 360);
  aimCone(cone, eye, focus, { upright, across: upright * camera.aspect });
  return { eye, cone, frustum };
}

function pointOf(level: TerrainLevel, vertex: number, out: Vector3): Vector3 {
  const { positions, origin } = level;
  return out.set(
    positions[vertex * 3]! + origin[0]!,
    positions[vertex * 3 + 1]! + origin[1]!,
    positions[vertex * 3 + 2]! + origin[2]!,
  );
}

/** Vertices of omitted triangles that are inside three's frustum, and the number of omitted triangles. */
function hiddenButSeen(level: TerrainLevel, finer: TerrainLevel, cone: ViewCone, frustum: Frustum) {
  const sectors = ownSectors();
  writeSectors(sectors, level, finer);
  const range = { start: 0, count: 0 };
  visibleRange(range, sectors, level, cone);
  const all = sectors.starts.at(-1)! / 2;
  const point = new Vector3();
  let wrong = 0;
  for (let n = range.start + range.count; n < range.start + all; n++)
    if (frustum.containsPoint(pointOf(level, sectors.indices[n % all]!, point))) wrong++;
  return { wrong, left: all - range.count, all };
}

describe('culled ground', () => {
  it.each(['Luna', 'Earth', 'Mars', 'Phobos'])('is outside the picture, on %s', (name) => {
    const frame = frameOn(name);
    const rng = createRandom(7);
    let [left, all] = [0, 0];
    for (const spacing of [0.8, 6.4, 102.4, 1638.4]) {
      const finer = levelOf(frame, spacing / 2, 20, -35);
      const level = levelOf(frame, spacing, 20, -35);
      for (let n = 0; n < 60; n++) {
        const { cone, frustum } = eyeAt(rng, 10 * 40 ** rng());
        const found = hiddenButSeen(level, finer, cone, frustum);
        expect(found.wrong).toBe(0);
        left += found.left;
        all += found.all;
      }
    }
    // Something must be omitted: what is behind a level view.
    expect(left / all).toBeGreaterThan(name === 'Phobos' ? 0.1 : 0.2);
  });

  it('over the horizon is behind the body, and near ground never is', () => {
    let hidden = 0;
    for (const name of ['Luna', 'Earth', 'Phobos']) {
      const frame = frameOn(name);
      for (const height of [2, 60, 3000]) {
        const eye = Float64Array.of(40, height, -25);
        const base = frame.radius - 30;
        for (let spacing = 0.4; spacing < 9000; spacing *= 2) {
          const level = levelOf(frame, spacing, 0, 0);
          if (!isOverHorizon(level, CELLS / 4 - 1, eye, -30)) continue;
          expect(spacing).toBeGreaterThan(5);
          hidden++;
          expect(nearestToCentre(level, eye, frame.radius)).toBeLessThan(base);
        }
      }
    }
    expect(hidden).toBeGreaterThan(10);
  });
});

/** The largest distance from the body's centre at which a line of sight to a level's outer points passes. */
function nearestToCentre(level: TerrainLevel, eye: Float64Array, radius: number): number {
  const from = new Vector3(eye[0], eye[1]! + radius, eye[2]);
  const to = new Vector3();
  let worst = -Infinity;
  for (let vertex = 0; vertex <= CELLS; vertex++) {
    pointOf(level, vertex, to).y += radius;
    const way = to.clone().sub(from);
    const share = Math.min(Math.max(-from.dot(way) / way.lengthSq(), 0), 1);
    worst = Math.max(worst, from.clone().addScaledVector(way, share).length());
  }
  return worst;
}

describe('view cone', () => {
  it('intersects every circle that is partly in the picture', () => {
    const rng = createRandom(3);
    const point = new Vector3();
    let outside = 0;
    for (let n = 0; n < 4000; n++) {
      const { cone, frustum } = eyeAt(rng, 24);
      point.set(rng() * 600 - 300, rng() * 40 - 20, rng() * 600 - 300);
      const [x, z] = [point.x + rng() * 4 - 2, point.z + rng() * 4 - 2];
      const meets = coneMeets(cone, x, z, Math.hypot(x - point.x, z - point.z) + 1e-9);
      if (frustum.containsPoint(point)) expect(meets).toBe(true);
      if (!meets) outside++;
    }
    expect(outside).toBeGreaterThan(400);
  });
});
