import { type Controls, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { type Predictor } from '../../../src/prediction';
import { type ServerFrame, type ShipState } from '../../../src/wire';
import { frameAt, STILL } from './restingShip';

export const OWN = { ownShipId: 'ship-1' };
export const thrust = (thrustLevel: number): Controls => ({ ...NEUTRAL_CONTROLS, thrustLevel });
export const named = (shipId: string, more: Partial<ShipState> = {}): ShipState => ({
  ...STILL,
  shipId,
  ...more,
});

/** Frames of these ticks, each when a server of `rate` Hz sends it, and a display frame after each. */
export function feed(
  predictor: Predictor,
  ticks: Iterable<number>,
  rate: number,
  from: number,
  more: Partial<ServerFrame> = {},
) {
  let now = from;
  let first = Number.NaN;
  for (const tick of ticks) {
    if (Number.isNaN(first)) first = tick;
    now = from + (tick - first) / rate;
    predictor.receive(frameAt(tick, rate, more), now);
    predictor.advance(null, now);
  }
  return now;
}

export const range = (from: number, to: number, step = 1) =>
  Array.from({ length: Math.ceil((to - from) / step) }, (_, i) => from + i * step);
