import type { ShipView, WorldView } from '../../prediction';

/** The readout's own game clock and the ship it follows, from view to view. */
export interface ViewClock {
  shipId: string;
  body: number;
  /** Game s since the first view; constant while the game is paused, never decreasing. */
  now: number;
  /** Game s since the view before. */
  elapsed: number;
  tick: number;
  sinceTick: number;
  /** Where the ship was, relative to its body, m. */
  readonly position: Float64Array;
}

/** m: largest move by a correction; more is a respawn. */
const MAX_CORRECTION = 100;

export function createViewClock(): ViewClock {
  const position = new Float64Array(3);
  return { shipId: '', body: NaN, now: 0, elapsed: NaN, tick: NaN, sinceTick: NaN, position };
}

/** Reads the next view; false when the ship is another one or was moved elsewhere. */
export function followView(out: ViewClock, view: WorldView, ship: ShipView): boolean {
  const ticks = view.tick - out.tick;
  // NaN at the first view.
  const passed = (ticks * view.timeScale) / view.tickRate + view.sinceTick - out.sinceTick;
  out.elapsed = passed > 0 ? passed : 0;
  out.now += out.elapsed;
  const same = out.shipId === ship.shipId && out.body === ship.body && inReach(out, ship);
  out.shipId = ship.shipId;
  out.body = ship.body;
  out.tick = view.tick;
  out.sinceTick = view.sinceTick;
  out.position.set(ship.position);
  return same;
}

/** Twice the distance that its speed allows, since the ship may have been faster in between. */
function inReach(out: ViewClock, ship: ShipView): boolean {
  let way = 0;
  let speed = 0;
  for (let k = 0; k < 3; k++) {
    way += (ship.position[k]! - out.position[k]!) ** 2;
    speed += ship.velocity[k]! ** 2;
  }
  return Math.sqrt(way) < MAX_CORRECTION + 2 * Math.sqrt(speed) * out.elapsed;
}
