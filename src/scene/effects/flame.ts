import { Color, PointLight, Vector4 } from 'three';
import type { ShipView } from '../../prediction';

/** Members of a drawn ship (ShipActor): its position, the direction of its exhaust, and whether any nozzle burns. */
interface BurningShip {
  readonly place: Float64Array;
  readonly blows: Float64Array;
  readonly jets: { readonly visible: boolean };
}

/** Shared by the materials that the flame lights. */
export interface FlameUniforms {
  /** Place of the flame relative to the eye, m; then its strength, or, below 0, minus the radius of a wreck's scorched ground in m. */
  readonly flame: { readonly value: Vector4 };
  readonly flameColour: { readonly value: Color };
}

/** The main engine's flame as a light: on ground and dust through their own shaders, on hulls and stones through three's light. */
export interface Flame {
  readonly light: PointLight;
  readonly uniforms: FlameUniforms;
  /** The flame of the watched ship; `eye` local, m; `flicker` around 1. */
  place(actor: BurningShip, ship: ShipView, eye: Float64Array, flicker: number): void;
  dispose(): void;
}

/** At full throttle, in the shaders' units: radiance of white ground 1 m below. */
const STRENGTH = 60;
/** Share of it in three's light: with all of it, metal beside the flame would be white. */
const ON_HULLS = 0.35 * Math.PI;
/** Of a ship's height: how far below its centre of mass the flame is brightest, and how wide a wreck scorches the ground. */
const BELOW = 0.8;
const SCORCH = 3;

export function createFlame(): Flame {
  const colour = new Color(1, 0.62, 0.32);
  const uniforms = { flame: { value: new Vector4() }, flameColour: { value: colour } };
  const light = new PointLight(colour, 0);
  return {
    light,
    uniforms,
    place(actor, ship, eye, flicker) {
      const height = ship.shipClass.groundContactOffset;
      const { value } = uniforms.flame;
      const { place, blows } = actor;
      const reach = BELOW * height;
      value.x = place[0]! - eye[0]! + blows[0]! * reach;
      value.y = place[1]! - eye[1]! + blows[1]! * reach;
      value.z = place[2]! - eye[2]! + blows[2]! * reach;
      const burning = actor.jets.visible ? ship.controls.thrustLevel * STRENGTH * flicker : 0;
      value.w = ship.shownState === 'crashed' ? -SCORCH * height : burning;
      light.position.set(value.x, value.y, value.z);
      light.intensity = burning * ON_HULLS;
    },
    dispose() {
      light.dispose();
    },
  };
}
