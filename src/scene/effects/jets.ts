import {
  AdditiveBlending,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  type Mesh,
  ShaderMaterial,
  Vector3,
} from 'three';
import type { Controls, ShipClass } from '../../dynamics';
import type { ShipModel } from '../ships/shipModel';

/** Nozzles of a model at most: four engines and eight clusters of four. */
const MAX_NOZZLES = 36;

const VERTEX = /* glsl */ `
attribute vec3 mouth;
attribute vec2 jet;
uniform float power[${MAX_NOZZLES}];
varying float vAlong;
varying float vPower;
varying vec3 vNormal;
varying vec3 vToEye;
void main() {
  float strength = power[int(jet.x + 0.5)];
  vec3 grown = mouth + (position - mouth) * (strength > 0.0 ? 0.35 + 0.65 * strength : 0.0);
  vec4 mvPosition = modelViewMatrix * vec4(grown, 1.0);
  vAlong = jet.y;
  vPower = strength;
  vNormal = normalMatrix * normal;
  vToEye = -mvPosition.xyz;
  gl_Position = projectionMatrix * mvPosition;
}`;
const FRAGMENT = /* glsl */ `
uniform vec3 core;
uniform vec3 edge;
uniform float flicker;
varying float vAlong;
varying float vPower;
varying vec3 vNormal;
varying vec3 vToEye;
void main() {
  float facing = abs(dot(normalize(vNormal), normalize(vToEye)));
  float fade = 1.0 - vAlong;
  float light = fade * fade * fade * facing * facing * vPower * flicker;
  gl_FragColor = vec4(mix(edge, core, fade * fade * facing) * light, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

export function createJetMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    blending: AdditiveBlending,
    uniforms: {
      power: { value: new Float32Array(MAX_NOZZLES) },
      core: { value: new Vector3(2.2, 1.75, 1.25) },
      edge: { value: new Vector3(0.75, 0.42, 0.9) },
      flicker: { value: 1 },
    },
  });
}

/** Cones at every nozzle; without air the gas spreads wide. */
export function buildJets(model: ShipModel, inAir: boolean): BufferGeometry {
  const cones = conesOf(model, inAir ? 0.1 : 0.42, inAir ? 13 : 11);
  const total = cones.length * CONE_CORNERS;
  const out: Corners = {
    positions: new Float32Array(3 * total),
    normals: new Float32Array(3 * total),
    mouths: new Float32Array(3 * total),
    jets: new Float32Array(2 * total),
  };
  cones.forEach((cone, n) => writeCone(out, n * CONE_CORNERS, cone));
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(out.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(out.normals, 3));
  geometry.setAttribute('mouth', new BufferAttribute(out.mouths, 3));
  geometry.setAttribute('jet', new BufferAttribute(out.jets, 2));
  return geometry;
}

interface Cone {
  readonly at: readonly [number, number, number];
  readonly blows: Vector3;
  readonly radius: number;
  readonly length: number;
  /** Growth of the radius per metre of length. */
  readonly spread: number;
  readonly nozzle: number;
}

/** An engine has two cones, one inside the other; `lengths`: length of the outer one in radii. */
function conesOf({ engines, thrusters }: ShipModel, spread: number, lengths: number): Cone[] {
  const down = new Vector3(0, 0, -1);
  const ofEngines = engines.flatMap(({ at, radius }, nozzle): Cone[] => [
    { at, blows: down, radius, length: radius * lengths, spread, nozzle },
    { at, blows: down, radius: radius * 0.6, length: radius * 6, spread: spread * 0.15, nozzle },
  ]);
  const ofThrusters = thrusters.map(({ at, blows }, n): Cone => {
    const nozzle = engines.length + n;
    return { at, blows: new Vector3(...blows), radius: 0.09, length: 2.1, spread: 0.3, nozzle };
  });
  return [...ofEngines, ...ofThrusters];
}

/** Attributes of all corners, three per triangle: two numbers per corner in `jets`, three in the others. */
interface Corners {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly mouths: Float32Array;
  readonly jets: Float32Array;
}

const SIDES = 14;
const STEPS = 5;
const CONE_CORNERS = STEPS * SIDES * 6;
/** Points of a cone, one row per step; the last point of a row repeats the first. */
const ROW = SIDES + 1;
const points = new Float64Array((STEPS + 1) * ROW * 3);
const outwards = new Float64Array(ROW * 3);

function writeCone(out: Corners, first: number, cone: Cone): void {
  placePoints(cone);
  let to = first;
  const corner = (step: number, side: number) => {
    for (let k = 0; k < 3; k++) {
      out.positions[3 * to + k] = points[3 * (step * ROW + side) + k]!;
      out.normals[3 * to + k] = outwards[3 * side + k]!;
      out.mouths[3 * to + k] = cone.at[k]!;
    }
    out.jets[2 * to] = cone.nozzle;
    out.jets[2 * to + 1] = step / STEPS;
    to++;
  };
  for (let step = 0; step < STEPS; step++) {
    for (let side = 0; side < SIDES; side++) {
      corner(step, side);
      corner(step + 1, side);
      corner(step, side + 1);
      corner(step, side + 1);
      corner(step + 1, side);
      corner(step + 1, side + 1);
    }
  }
}

function placePoints({ at, blows, radius, length, spread }: Cone): void {
  const across = new Vector3(blows.z, blows.x, blows.y).cross(blows).normalize();
  const other = blows.clone().cross(across);
  for (let side = 0; side < ROW; side++) {
    const angle = (side / SIDES) * 2 * Math.PI;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    for (let k = 0; k < 3; k++) {
      const outward = across.getComponent(k) * cos + other.getComponent(k) * sin;
      outwards[3 * side + k] = outward;
      for (let step = 0; step <= STEPS; step++) {
        const along = step / STEPS;
        const r = radius + spread * length * along;
        points[3 * (step * ROW + side) + k] = at[k]! + blows.getComponent(k) * length * along + outward * r;
      }
    }
  }
}

/** Whether any nozzle may burn: most ships of a fleet are at rest. */
export function commandsPower(controls: Controls): boolean {
  const { rotationInput: turn, translationInput: push } = controls;
  return (
    controls.thrustLevel > 0 ||
    controls.attitudeHold ||
    controls.attitudeMode !== 'none' ||
    turn[0] !== 0 ||
    turn[1] !== 0 ||
    turn[2] !== 0 ||
    push[0] !== 0 ||
    push[1] !== 0 ||
    push[2] !== 0
  );
}

/**
 * Writes the power of each nozzle, 0 … 1: engines by throttle, thrusters by their contribution to the command. Returns
 * whether any burns.
 */
export function writePower(
  out: Float32Array,
  model: ShipModel,
  controls: Controls,
  turning: ArrayLike<number>,
): boolean {
  out.fill(0);
  let any = controls.thrustLevel > 0;
  const { engines, thrusters } = model;
  for (let n = 0; n < engines.length; n++) out[n] = controls.thrustLevel;
  const [tx, ty, tz] = controls.translationInput;
  const [rx, ry, rz] = [turning[0]!, turning[1]!, turning[2]!];
  for (let n = 0; n < thrusters.length; n++) {
    const { at, blows } = thrusters[n]!;
    const push = -(blows[0] * tx + blows[1] * ty + blows[2] * tz);
    // Torque of the push −blows at `at`, about each axis, per metre of arm.
    const reach = Math.hypot(at[0], at[1], at[2]);
    const turn =
      (rx * (blows[1] * at[2] - blows[2] * at[1]) +
        ry * (blows[2] * at[0] - blows[0] * at[2]) +
        rz * (blows[0] * at[1] - blows[1] * at[0])) /
      reach;
    const wanted = push + turn;
    if (wanted <= 0.15) continue;
    out[engines.length + n] = Math.min(1, wanted);
    any = true;
  }
  return any;
}

/** The command of pilot or rate damping to the thrusters about body x, y, z. */
export function commandedTurn(out: Float64Array, controls: Controls, bodyRates: ArrayLike<number>): void {
  const [x, y, z] = controls.rotationInput;
  const damped = controls.attitudeHold || controls.attitudeMode !== 'none';
  const byHand = x !== 0 || y !== 0 || z !== 0;
  for (let i = 0; i < 3; i++) {
    const rate = bodyRates[i]!;
    const still = Math.abs(rate) < 0.01;
    out[i] = byHand
      ? controls.rotationInput[i]!
      : damped && !still
        ? Math.max(-1, Math.min(1, -rate * 6))
        : 0;
  }
}

/** A mesh that draws with its own nozzles' powers. */
export function showPower(mesh: Mesh<BufferGeometry, ShaderMaterial>, power: Float32Array): void {
  mesh.onBeforeRender = () => {
    (mesh.material.uniforms['power']!.value as Float32Array).set(power);
    mesh.material.uniformsNeedUpdate = true;
  };
}

/** Whether a class can burn with this fuel: an empty ship has no jets. */
export function canBurn(shipClass: ShipClass, fuel: number): boolean {
  return fuel > 0 && (shipClass.mainEngineThrust > 0 || shipClass.rcsLever > 0);
}
