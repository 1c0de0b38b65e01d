import { BufferGeometry, Color, Group, Mesh, type Quaternion, ShaderMaterial, type Vector3 } from 'three';

/** The server's state of the watched ship as a translucent hull. */
export interface Ghost {
  readonly group: Group;
  setHull(hull: BufferGeometry): void;
  /** `place` relative to the eye, m. */
  show(visible: boolean, place: Vector3, turn: Quaternion): void;
  dispose(): void;
}

const VERTEX = /* glsl */ `
varying vec3 vNormal;
varying vec3 vToEye;
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  vNormal = normalMatrix * normal;
  vToEye = -mvPosition.xyz;
  gl_Position = projectionMatrix * mvPosition;
}`;
/** Densest where the hull turns away from the eye: the outline is clear, and the ship behind it is seen through the middle. */
const FRAGMENT = /* glsl */ `
uniform vec3 colour;
varying vec3 vNormal;
varying vec3 vToEye;
void main() {
  float facing = abs(dot(normalize(vNormal), normalize(vToEye)));
  gl_FragColor = vec4(colour, 0.16 + 0.6 * (1.0 - facing) * (1.0 - facing));
}`;

export function createGhost(colour: number): Ghost {
  // Pushed back: where ghost and ship coincide, only the ship is visible.
  const behind = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 8 };
  const shaders = { vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, ...behind };
  const uniforms = { colour: { value: new Color(colour) } };
  // Depth first, so that only the nearest surface is drawn.
  const depth = new ShaderMaterial({ ...shaders, uniforms, colorWrite: false });
  const surface = new ShaderMaterial({ ...shaders, uniforms, depthWrite: false });
  const parts = [depth, surface].map((material, n) => {
    const mesh = new Mesh(new BufferGeometry(), material);
    mesh.renderOrder = 5 + n;
    mesh.frustumCulled = false;
    return mesh;
  });
  const group = new Group();
  group.add(...parts);
  return {
    group,
    setHull(hull) {
      for (const part of parts) part.geometry = hull;
    },
    show(visible, place, turn) {
      group.visible = visible;
      group.position.copy(place);
      group.quaternion.copy(turn);
    },
    dispose() {
      depth.dispose();
      surface.dispose();
    },
  };
}
