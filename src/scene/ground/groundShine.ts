import type { ShaderMaterial } from 'three';
import type { ShipView } from '../../prediction';
import type { ShipActor } from '../ships/shipActor';

/** What a ship does to the ground's look: its flame lights it, its wreck scorches it. `eye` local, m. */
export function shineOnGround(
  material: ShaderMaterial,
  actor: ShipActor,
  ship: ShipView,
  eye: Float64Array,
): void {
  const flame = material.uniforms['flame']!.value as number[];
  const reach = ship.shipClass.groundContactOffset * 0.8;
  for (let i = 0; i < 3; i++) flame[i] = actor.place[i]! - eye[i]! + actor.blows[i]! * reach;
  const lit = actor.jets.visible ? ship.controls.thrustLevel * 60 : 0;
  flame[3] = ship.shownState === 'crashed' ? -3 * ship.shipClass.groundContactOffset : lit;
}
