import type { ShipView } from '../../prediction';

/** One touchdown, from the first touch to rest (HUD, touchdown card). Speeds relative to the turning ground. */
export interface Touchdown {
  /** Whether a touch was seen: a ship first seen on the ground has no card. */
  known: boolean;
  /** 'open' until the ship has landed, tipped or crashed. */
  outcome: ShipView['touchdown']['outcome'];
  /** The law's impact speed at the first touch, m/s. */
  verticalSpeed: number;
  /** Just before the first touch, m/s. */
  horizontalSpeed: number;
  /** Number of touches after the first. */
  bounces: number;
  /** Distance along the ground while on it, without hops, m. */
  slideMetres: number;
  /** Game s from the first touch to rest, or until now. */
  settleSeconds: number;
  /** Degrees, since the first touch, including the tilt at that touch. */
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

/** The prediction records it substep by substep, so that no touch is missed between two views. */
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
