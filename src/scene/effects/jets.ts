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
  const out = {
    positions: [] as number[],
    normals: [] as number[],
    mouths: [] as number[],
    jets: [] as number[],
  };
  const spread = inAir ? 0.1 : 0.42;
  model.engines.forEach(({ at, radius }, n) => {
    const down = new Vector3(0, 0, -1);
    addCone(out, { at, blows: down, radius, length: radius * (inAir ? 13 : 11), spread, nozzle: n });
    addCone(out, {
      at,
      blows: down,
      radius: radius * 0.6,
      length: radius * 6,
      spread: spread * 0.15,
      nozzle: n,
    });
  });
  model.thrusters.forEach(({ at, blows }, n) => {
    const way = new Vector3(...blows);
    addCone(out, {
      at,
      blows: way,
      radius: 0.09,
      length: 2.1,
      spread: 0.3,
      nozzle: model.engines.length + n,
    });
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(out.positions), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(out.normals), 3));
  geometry.setAttribute('mouth', new BufferAttribute(new Float32Array(out.mouths), 3));
  geometry.setAttribute('jet', new BufferAttribute(new Float32Array(out.jets), 2));
  return geometry;
}

interface Cone {
  readonly at: readonly [number, number, number];
  readonly blows: Vector3;
  readonly radius: number;
  readonly length: number;
  /** Growth of the radius a metre of length. */
  readonly spread: number;
  readonly nozzle: number;
}

interface Arrays {
  readonly positions: number[];
  readonly normals: number[];
  readonly mouths: number[];
  readonly jets: number[];
}

const SIDES = 14;
const STEPS = 5;

function addCone(out: Arrays, { at, blows, radius, length, spread, nozzle }: Cone): void {
  const across = new Vector3(blows.z, blows.x, blows.y).cross(blows).normalize();
  const other = blows.clone().cross(across);
  const vertex = (step: number, side: number) => {
    const along = step / STEPS;
    const angle = (side / SIDES) * 2 * Math.PI;
    const r = radius + spread * length * along;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    for (const axis of ['x', 'y', 'z'] as const) {
      const outward = across[axis] * cos + other[axis] * sin;
      const i = axis === 'x' ? 0 : axis === 'y' ? 1 : 2;
      out.positions.push(at[i] + blows[axis] * length * along + outward * r);
      out.normals.push(outward);
      out.mouths.push(at[i]);
    }
    out.jets.push(nozzle, along);
  };
  for (let step = 0; step < STEPS; step++) {
    for (let side = 0; side < SIDES; side++) {
      vertex(step, side);
      vertex(step + 1, side);
      vertex(step, side + 1);
      vertex(step, side + 1);
      vertex(step + 1, side);
      vertex(step + 1, side + 1);
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
