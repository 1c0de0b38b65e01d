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

  /** All places are relative to the own ship, subtracted in doubles: a planet's radius does not fit into a float. */
  return (view) => {
    const own = view.own;
    if (own === null) return;
    const [x, y, z] = own.meshPosition;
    const up = new THREE.Vector3(x, y, z).normalize();
    ship.quaternion.set(...own.meshAttitude); // [x, y, z, w], as in three
    ghost.visible = own.serverKnown;
    ghost.quaternion.set(...own.ghostAttitude);
    ghost.position.set(own.ghostPosition[0] - x, own.ghostPosition[1] - y, own.ghostPosition[2] - z);
    layGround(patch, { own, body: view.bodies[own.body], up });
    const east = new THREE.Vector3(0, 0, 1).cross(up).normalize();
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
function layGround(patch, { own, body, up }) {
  const east = new THREE.Vector3(0, 0, 1).cross(up).normalize();
  const north = up.clone().cross(east);
  const [x, y, z] = own.meshPosition;
  const toBody = new THREE.Quaternion(...body.attitude).invert(); // ICRF axes to the body's
  const places = patch.attributes.position;
  for (let i = 0; i < places.count; i++) {
    const a = ((i % (CELLS + 1)) / CELLS - 0.5) * SIZE;
    const b = (0.5 - Math.floor(i / (CELLS + 1)) / CELLS) * SIZE;
    const at = up.clone().multiplyScalar(body.radius).addScaledVector(east, a);
    at.addScaledVector(north, b).normalize();
    const n = at.clone().applyQuaternion(toBody);
    const radius = body.radius + terrainHeight(body.name, n.x, n.y, n.z);
    places.setXYZ(i, at.x * radius - x, at.y * radius - y, at.z * radius - z);
  }
  places.needsUpdate = true;
  patch.computeVertexNormals();
}
