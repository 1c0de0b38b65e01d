import { type Box3, type BufferAttribute, type BufferGeometry, InstancedMesh, Matrix4, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { SHIP_CLASSES } from '../../../src/dynamics';
import { createHulls, type Hulls } from '../../../src/scene/ships/hulls';
import { buildShip } from '../../../src/scene/ships/models/models';
import type { ShipActor } from '../../../src/scene/ships/shipActor';
import { createShipMaterial } from '../../../src/scene/ships/shipMaterial';
import type { ShipModel } from '../../../src/scene/ships/shipModel';

const EYE = Float64Array.of(0, 0, 0);

function actorAt(model: ShipModel, place: readonly number[], compression = [0, 0, 0, 0]): ShipActor {
  return {
    model,
    place: Float64Array.from(place),
    turn: Float64Array.of(0, 0, 0, 1),
    compression: Float32Array.from(compression),
    sunlit: 1,
  } as unknown as ShipActor;
}

const trianglesOf = (geometry: BufferGeometry) => geometry.getAttribute('position').count / 3;

function boxOf(geometry: BufferGeometry): Box3 {
  geometry.computeBoundingBox();
  return geometry.boundingBox!;
}

function placesOf(mesh: InstancedMesh): number[] {
  const matrix = new Matrix4();
  const at = new Vector3();
  return Array.from({ length: mesh.count }, (_, n) => {
    mesh.getMatrixAt(n, matrix);
    return at.setFromMatrixPosition(matrix).x;
  });
}

const drawnBy = ({ group }: Hulls) =>
  group.children
    .filter((child): child is InstancedMesh => child instanceof InstancedMesh)
    .filter(({ visible }) => visible);

describe.each(SHIP_CLASSES)('model of $name', (shipClass) => {
  const model = buildShip(shipClass);

  it('has fewer triangles at each lower level of detail, with the same feet and outline', () => {
    let finer = trianglesOf(model.geometry);
    const whole = boxOf(model.geometry);
    const coarser = model.coarser();
    expect(coarser.length).toBeGreaterThan(0);
    for (const geometry of coarser) {
      expect(trianglesOf(geometry)).toBeLessThan(finer / 1.3);
      finer = trianglesOf(geometry);
      const box = boxOf(geometry);
      expect(Math.abs(box.min.z - whole.min.z)).toBeLessThan(0.2);
      // Antennas and lamps are left out, the hull is kept.
      const [size, before] = [box.getSize(new Vector3()), whole.getSize(new Vector3())];
      for (const axis of ['x', 'y', 'z'] as const) {
        expect(size[axis] / before[axis]).toBeGreaterThan(0.75);
        expect(size[axis] / before[axis]).toBeLessThan(1.02);
      }
    }
    expect(trianglesOf(coarser.at(-1)!)).toBeLessThan(1500);
  });
});

describe('hulls', () => {
  const model = buildShip(SHIP_CLASSES[0]!);
  const material = createShipMaterial();

  it('draws a fleet in one mesh per level of detail, each ship in place, none lost when it grows', () => {
    const hulls = createHulls(material);
    const far = Array.from({ length: 60 }, (_, n) => 1000 + n);
    hulls.clear();
    hulls.put(actorAt(model, [5, 0, 0]), EYE, false);
    for (const x of far) hulls.put(actorAt(model, [x, 0, 0]), EYE, false);
    hulls.finish();
    const drawn = drawnBy(hulls);
    expect(drawn.map(({ count }) => count)).toEqual([1, 60]);
    expect(placesOf(drawn[1]!)).toEqual(far);
    expect(drawn.map(({ castShadow }) => castShadow)).toEqual([true, false]);
    hulls.clear();
    hulls.finish();
    expect(hulls.group.children.every(({ visible }) => !visible)).toBe(true);
    hulls.dispose();
  });

  it('draws the watched ship in full detail at any distance, with its own leg travel', () => {
    const hulls = createHulls(material);
    hulls.clear();
    hulls.put(actorAt(model, [6, 0, 0], [0.5, 0, 0, 0.25]), EYE, false);
    hulls.put(actorAt(model, [900, 0, 0], [0, 0.125, 0, 0]), EYE, true);
    hulls.finish();
    const mesh = drawnBy(hulls)[0]!;
    expect(placesOf(mesh)).toEqual([6, 900]);
    const travel = mesh.geometry.getAttribute('compression').array;
    expect([...travel.slice(0, 8)]).toEqual([0.5, 0, 0, 0.25, 0, 0.125, 0, 0]);
    hulls.dispose();
  });

  it('sends leg travel and sunlight to the GPU only where they changed, and places in every frame', () => {
    const hulls = createHulls(material);
    const legs = [0, 0, 0, 0];
    const sent = (sunlit: number) => {
      hulls.clear();
      hulls.put({ ...actorAt(model, [6, 0, 0], legs), sunlit }, EYE, true);
      hulls.finish();
      const mesh = drawnBy(hulls)[0]!;
      const { compression, sunlit: light } = mesh.geometry.attributes;
      return [mesh.instanceMatrix, compression!, light!].map(
        (attribute) => (attribute as BufferAttribute).version,
      );
    };
    const first = sent(0.7);
    const second = sent(0.7);
    expect(second).toEqual([first[0]! + 1, first[1], first[2]]);
    legs[3] = 0.1;
    expect(sent(0.7)).toEqual([second[0]! + 1, second[1]! + 1, second[2]]);
    expect(sent(0.6)).toEqual([second[0]! + 2, second[1]! + 1, second[2]! + 1]);
    hulls.dispose();
  });
});
