import { DirectionalLight, Group, HemisphereLight, Vector3 } from 'three';
import type { BodyLook } from './bodyLook';
import type { LocalFrame } from '../localFrame';

/** The sun and the light from around; its shadow map stays over the ship. */
export interface Sunlight {
  readonly group: Group;
  /** Local, unit, towards the sun. */
  readonly direction: Vector3;
  paint(look: BodyLook, frame: LocalFrame): void;
  /** The camera adapts at once, at the next `shade`. */
  adapt(): void;
  /**
   * Sets the share of the sun that reaches the watched ship, 0 … 1. Returns the camera's exposure, 1 in the sun, `seconds` after
   * the previous call: it adapts like an eye to the dark.
   */
  shade(share: number, seconds: number): number;
  /** Centres the shadow map on a local point, `reach` m to each side; `depth` m down-sun to the ground. */
  follow(place: Float64Array, eye: Float64Array, reach: number, depth: number): void;
  dispose(): void;
}

const MAP = 1024;
/** Additional exposure for a ship in the dark, and how fast it adapts, 1/s. */
const OPENS = 1.7;
const ADAPTS = 1.5;
/** A smaller difference in exposure is not seen. Each program would get a new number in every frame. */
const ADAPTED = 5e-4;

export function createSunlight(): Sunlight {
  const sun = createSun();
  const around = new HemisphereLight();
  const group = new Group();
  group.add(sun, sun.target, around);
  const direction = new Vector3(1, 0.2, 0).normalize();
  const side = new Vector3();
  const over = new Vector3();
  let exposure = NaN;

  return {
    group,
    direction,
    adapt() {
      exposure = NaN;
    },
    paint(look, frame) {
      direction.set(1, frame.sunSlope, 0).normalize();
      side.set(0, 0, 1);
      over.copy(direction).cross(side).normalize();
      const [r, g, b] = look.sunColour;
      sun.color.setRGB(r, g, b);
      sun.intensity = look.sunStrength * Math.PI * 0.62;
      const [fr, fg, fb] = look.fill;
      const [dr, dg, db] = look.dust;
      const bounce = look.sunStrength * 0.2;
      around.color.setRGB(fr * 3, fg * 3, fb * 3);
      around.groundColor.setRGB(fr + dr * bounce, fg + dg * bounce, fb + db * bounce);
    },
    shade(share, seconds) {
      // In a hill's shadow the ground below is dark too.
      around.intensity = Math.PI * (0.35 + 0.55 * share);
      const wanted = 1 + OPENS * (1 - share);
      // NaN: at once.
      const isAdapting = Math.abs(wanted - exposure) > ADAPTED;
      exposure = isAdapting ? wanted + (exposure - wanted) * Math.exp(-ADAPTS * seconds) : wanted;
      return exposure;
    },
    follow(place, eye, reach, depth) {
      // The map's grid of texels stays where it is in the world while the ship moves over it.
      const texel = (2 * reach) / MAP;
      const along = place[0]! * side.x + place[1]! * side.y + place[2]! * side.z;
      const up = place[0]! * over.x + place[1]! * over.y + place[2]! * over.z;
      const offSide = Math.round(along / texel) * texel - along;
      const offUp = Math.round(up / texel) * texel - up;
      const target = sun.target.position;
      target.set(place[0]! - eye[0]!, place[1]! - eye[1]!, place[2]! - eye[2]!);
      target.addScaledVector(side, offSide).addScaledVector(over, offUp);
      sun.position.copy(target).addScaledVector(direction, reach * 2);
      const { camera } = sun.shadow;
      camera.left = camera.bottom = -reach;
      camera.right = camera.top = reach;
      camera.near = 0;
      camera.far = reach * 2 + depth;
      camera.updateProjectionMatrix();
    },
    dispose() {
      sun.dispose();
    },
  };
}

function createSun(): DirectionalLight {
  const sun = new DirectionalLight();
  sun.castShadow = true;
  sun.shadow.mapSize.set(MAP, MAP);
  sun.shadow.bias = -0.0006;
  sun.shadow.normalBias = 0.02;
  sun.shadow.radius = 1.4;
  return sun;
}
