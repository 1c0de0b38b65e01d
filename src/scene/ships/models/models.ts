import type { ShipClass } from '../../../dynamics';
import { buildFrigate } from './frigate';
import { buildHauler } from './hauler';
import { buildLander } from './lander';
import type { ShipModel, Stance } from '../shipModel';

/** The model of a class; classes without a model are drawn as landers of their height and leg radius. */
export function buildShip(shipClass: ShipClass): ShipModel {
  const stance: Stance = { h: shipClass.groundContactOffset, legRadius: shipClass.legRadius };
  if (shipClass.name === 'fast_frigate') return buildFrigate(stance);
  if (shipClass.name === 'cargo_hauler') return buildHauler(stance);
  return buildLander(stance);
}
