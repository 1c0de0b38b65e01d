import { BufferAttribute, BufferGeometry, InstancedMesh, Mesh } from 'three';
import type { SceneParts } from './sceneParts';

/**
 * Begins to compile the programs of the first picture, the longest first. The GPU's compiler then
 * works on all of them while the world is loading and the ground is built; three by itself would compile each at its first draw, and wait.
 */
export function beginPrograms(parts: SceneParts): void {
  const { renderer, camera, scene, shipResources, ground, rocks, sky, markers, plumbLine } = parts;
  // Ships come later. Their programs depend on the material, on whether there are instances, and on the attributes' names.
  const none = new BufferAttribute(new Float32Array(0), 3);
  const shape = new BufferGeometry().setAttribute('position', none).setAttribute('normal', none);
  const hull = new InstancedMesh(shape, shipResources.hull.surface, 1);
  const jets = new Mesh(shape, shipResources.jet);
  for (const part of [hull, rocks.mesh, ground.mesh, jets, sky.group, markers.group, plumbLine.group])
    renderer.compile(part, camera, scene);
  hull.dispose();
}
