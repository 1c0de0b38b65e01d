import type { ShipState } from '../../wire';

/** The part of the world that one client receives. */
export interface Interest {
  /** m from the own ship; for a spectator all ships are equally near. */
  readonly radius: number;
  /** Ships at most, the own one included. */
  readonly most: number;
}

export const NEARBY: Interest = { radius: 200_000, most: 200 };

/**
 * Indices of the ships that a client sees: the own one first, then the others within the radius, nearest first.
 * @param own index of the own ship, −1 for a spectator
 */
export function shipsInSight(ships: readonly ShipState[], own: number, { radius, most }: Interest): number[] {
  const centre = ships[own];
  if (centre === undefined) return ships.slice(0, most).map((_, i) => i);
  const near: { readonly index: number; readonly distance: number }[] = [];
  const limit = radius * radius;
  for (let i = 0; i < ships.length; i++) {
    const distance = distanceSquared(ships[i]!, centre);
    if (i !== own && distance <= limit) near.push({ index: i, distance });
  }
  near.sort((a, b) => a.distance - b.distance);
  return [own, ...near.slice(0, most - 1).map(({ index }) => index)];
}

function distanceSquared(
  { position: [ax, ay, az] }: ShipState,
  { position: [bx, by, bz] }: ShipState,
): number {
  return (ax - bx) * (ax - bx) + (ay - by) * (ay - by) + (az - bz) * (az - bz);
}
