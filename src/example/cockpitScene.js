import * as THREE from 'three';
import { terrainHeight } from './terrain.js';

const CELLS = 48;
const SIZE = 400;

/** A box for the ship, a wire box for the server's newest state, and a patch of the client's own ground. */
export function createScene(canvas) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
  const camera = new THREE.PerspectiveCamera(50, 1, 0.5, 20000);
  const scene = new THREE.Scene();
  const box = new THREE.BoxGeometry(5, 5, 9);
  const ship = new THREE.Mesh(box, new THREE.MeshStandardMaterial({ color: 0xd8dde3 }));
  const ghost = new THREE.Mesh(box, new THREE.MeshBasicMaterial({ color: 0x7fe4ff, wireframe: true }));
  const patch = new THREE.PlaneGeometry(SIZE, SIZE, CELLS, CELLS);
  const stone = new THREE.MeshStandardMaterial({ color: 0x77726b, flatShading: true });
  const ground = new THREE.Mesh(patch, stone);
  const sun = new THREE.DirectionalLight(0xffffff, 3);
  scene.add(ship, ghost, ground, sun, new THREE.AmbientLight(0x334455, 2));

  /** All places are relative to the player's ship, subtracted in doubles: a planet's radius does not fit into a float. */
  return (view) => {
    const own = view.own;
    if (own === null) return;
    const here = new THREE.Vector3(...own.meshPosition);
    const up = here.clone().normalize();
    ship.quaternion.set(...own.meshAttitude); // [x, y, z, w], as in three
    ghost.visible = own.serverKnown;
    const turned = new THREE.Quaternion(...view.bodies[own.body].attitude); // the body's axes to ICRF
    ghost.quaternion.set(...own.ghostAttitude).premultiply(turned);
    ghost.position.set(...own.ghostPosition).applyQuaternion(turned);
    ghost.position.sub(here);
    const east = new THREE.Vector3(0, 0, 1).cross(up).normalize();
    layGround(patch, { here, body: view.bodies[own.body], up, east });
    sun.position.copy(up).add(east).multiplyScalar(100);
    camera.up.copy(up);
    camera.position.copy(up).multiplyScalar(14).addScaledVector(east, -38);
    camera.lookAt(0, 0, 0);
    renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
    camera.aspect = canvas.clientWidth / canvas.clientHeight;
    camera.updateProjectionMatrix();
    renderer.render(scene, camera);
  };
}

/** Puts each vertex of the patch below the ship onto the client's own ground. */
function layGround(patch, { here, body, up, east }) {
  const north = up.clone().cross(east);
  const toBody = new THREE.Quaternion(...body.attitude).invert(); // ICRF axes to the body's
  const places = patch.attributes.position;
  for (let i = 0; i < places.count; i++) {
    const a = ((i % (CELLS + 1)) / CELLS - 0.5) * SIZE;
    const b = (0.5 - Math.floor(i / (CELLS + 1)) / CELLS) * SIZE;
    const at = up.clone().multiplyScalar(body.radius).addScaledVector(east, a);
    at.addScaledVector(north, b).normalize();
    const n = at.clone().applyQuaternion(toBody);
    const radius = body.radius + terrainHeight(body.name, n.x, n.y, n.z);
    places.setXYZ(i, at.x * radius - here.x, at.y * radius - here.y, at.z * radius - here.z);
  }
  places.needsUpdate = true;
  patch.computeVertexNormals();
}
