import type { ShipView } from '../../prediction';

/** One touchdown, from the first touch to rest (HUD, touchdown card). Speeds relative to the turning ground. */
export interface Touchdown {
  /** A touch was seen: a ship met already on the ground has no card. */
  known: boolean;
  /** 'open' until the ship has landed, tipped or crashed. */
  outcome: ShipView['touchdown']['outcome'];
  /** The law's impact speed at the first touch, m/s. */
  verticalSpeed: number;
  /** Just before the first touch, m/s. */
  horizontalSpeed: number;
  /** Times it came down again. */
  bounces: number;
  /** Way along the ground while on it, hops not counted, m. */
  slideMetres: number;
  /** Game s from the first touch to rest, or so far. */
  settleSeconds: number;
  /** Degrees, since the first touch; the tilt it came with counts. */
  largestTilt: number;
}

export function createTouchdown(): Touchdown {
  return {
    known: false,
    outcome: 'open',
    verticalSpeed: 0,
    horizontalSpeed: 0,
    bounces: 0,
    slideMetres: 0,
    settleSeconds: 0,
    largestTilt: 0,
  };
}

/** The prediction keeps it substep by substep, so that no touch falls between two views. */
export function readTouchdown(out: Touchdown, { touchdown }: ShipView): void {
  out.known = touchdown.known;
  out.outcome = touchdown.outcome;
  out.verticalSpeed = touchdown.verticalSpeed;
  out.horizontalSpeed = touchdown.horizontalSpeed;
  out.bounces = touchdown.bounces;
  out.slideMetres = touchdown.slideMetres;
  out.settleSeconds = touchdown.settleSeconds;
  out.largestTilt = (touchdown.largestTilt * 180) / Math.PI;
}
