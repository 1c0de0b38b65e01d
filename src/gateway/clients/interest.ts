import type { ShipState } from '../../wire';

/** Area of interest: the part of the world that one client receives. */
export interface Interest {
  /** Distance from the player's ship, m. A spectator has no radius. */
  readonly radius: number;
  /** Maximum number of ships, the player’s included. */
  readonly maxShips: number;
}

export const DEFAULT_INTEREST: Interest = { radius: 200_000, maxShips: 200 };

/**
 * Indices of the ships in a client's area of interest: the player's ship, then the others within the radius, nearest first.
 * @param own index of the player's ship, −1 for a spectator
 */
export function shipsInSight(
  ships: readonly ShipState[],
  own: number,
  { radius, maxShips }: Interest,
): number[] {
  const centre = ships[own];
  if (centre === undefined) return ships.slice(0, maxShips).map((_, i) => i);
  const near: { readonly index: number; readonly distance: number }[] = [];
  const limit = radius * radius;
  for (let i = 0; i < ships.length; i++) {
    const distance = distanceSquared(ships[i]!, centre);
    if (i !== own && distance <= limit) near.push({ index: i, distance });
  }
  near.sort((a, b) => a.distance - b.distance);
  return [own, ...near.slice(0, maxShips - 1).map(({ index }) => index)];
}

function distanceSquared(
  { position: [ax, ay, az] }: ShipState,
  { position: [bx, by, bz] }: ShipState,
): number {
  return (ax - bx) * (ax - bx) + (ay - by) * (ay - by) + (az - bz) * (az - bz);
}
