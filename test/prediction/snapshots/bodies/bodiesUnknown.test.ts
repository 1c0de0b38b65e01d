import { describe, expect, it } from 'vitest';
import { createPredictor, type Predictor } from '../../../../src/prediction';
import type { ServerFrame, ShipState } from '../../../../src/wire';
import { named, OWN, range } from '../../faults/feed';
import { frameAt, helloAt, STILL } from '../../faults/restingShip';

/** m/s of the body, which takes its landed ship along. */
const SPEED = 1000;
const BODY = { ...helloAt(0, 1).bodies[0]!, velocity: [SPEED, 0, 0] as const };

/** The landed ship where it is `seconds` of game time after the start, without a relative state. */
function shipAfter(seconds: number, more: Partial<ShipState> = {}): ShipState {
  return named('ship-1', {
    position: [SPEED * seconds, STILL.position[1], 0],
    velocity: [SPEED, 0, 0],
    relativePosition: null,
    relativeVelocity: null,
    ...more,
  });
}

interface Send extends Partial<ServerFrame> {
  readonly tick: number;
  /** Game s since the start. */
  readonly at: number;
}

/** Receives frames without bodies, one per wall second, and returns the provenance after each. */
function provenances(predictor: Predictor, sends: readonly Send[], from = 0): string[] {
  return sends.map(({ tick, at, tickRate = 5, ...more }, i) => {
    const now = from + i;
    predictor.receive(frameAt(tick, tickRate, { bodies: [], ships: [shipAfter(at)], ...more }), now);
    predictor.advance(null, now);
    return predictor.view(now).own!.provenance;
  });
}

/** Ten seconds of a server of 5 Hz that sends at 1 Hz. */
const USUAL: readonly Send[] = range(0, 10).map((at) => ({ tick: 5 * at, at }));
const created = () => createPredictor({ ...OWN, defaults: { bodies: [BODY] } });

describe('bodies that are not sent', () => {
  it('are known as long as frames have the time: the ship is confirmed', () => {
    expect(provenances(created(), USUAL).slice(2)).toEqual(Array(8).fill('confirmed'));
  });

  it('are unknown once the tempo changed between two frames, until they are sent', () => {
    const predictor = created();
    provenances(predictor, USUAL);
    // For 2 s of the 3 s the server ticked at 10 Hz already.
    const faster = range(0, 6).map((k) => ({ tick: 65 + 10 * k, at: 11.5 + k, tickRate: 10 }));
    expect(provenances(predictor, faster, 10)).not.toContain('confirmed');
    const told = { ...BODY, position: [SPEED * 17.5, 0, 0] as const };
    const next = [
      { tick: 125, at: 17.5, tickRate: 10, bodies: [told] },
      { tick: 135, at: 18.5, tickRate: 10 },
    ];
    expect(provenances(predictor, next, 16)).toEqual(['confirmed', 'confirmed']);
    expect(predictor.view(17).own!.position[0]).toBeCloseTo(0, 3);
  });

  it('stay known where the tempo changed from one tick to the next', () => {
    const predictor = created();
    const each = range(0, 40).map((tick) => ({ tick, at: tick / 5 }));
    each.forEach((send, i) => provenances(predictor, [send], i / 5));
    const slower = { tick: 40, at: 8, timeScale: 0.5 };
    const later = range(41, 46).map((tick) => ({ tick, at: 8 + (tick - 40) / 10, timeScale: 0.5 }));
    const seen = [slower, ...later].flatMap((send, i) => provenances(predictor, [send], 8 + i / 5));
    expect(seen).toEqual(Array(6).fill('confirmed'));
  });

  it.each([0, 900_000])('are unknown after a restart at tick %i', (first) => {
    const predictor = created();
    provenances(predictor, USUAL);
    const anew = range(0, 6).map((k) => ({ tick: first + 5 * k, at: 20 + k }));
    const seen = provenances(predictor, anew, 14);
    expect(predictor.view(19).tick).toBeGreaterThanOrEqual(first + 25);
    expect(predictor.view(19).tick).toBeLessThan(first + 40);
    expect(seen.slice(2)).toEqual(Array(4).fill('predicted'));
  });

  it('are known after a restart whose hello has them', () => {
    const predictor = createPredictor(OWN);
    const helloOf = (at: number) => ({
      ...helloAt(0, 5),
      bodies: [{ ...BODY, position: [SPEED * at, 0, 0] as const }],
    });
    predictor.receive(helloOf(0), 0);
    provenances(predictor, USUAL);
    predictor.receive(helloOf(20), 14);
    const anew = range(0, 6).map((k) => ({ tick: 5 * k, at: 20 + k }));
    expect(provenances(predictor, anew, 14).slice(2)).toEqual(Array(4).fill('confirmed'));
  });

  it('do not matter to a ship whose relative state is sent', () => {
    const predictor = created();
    provenances(predictor, USUAL);
    const { relativePosition, relativeVelocity } = STILL;
    const ships = [shipAfter(0, { relativePosition, relativeVelocity })];
    const anew = range(0, 6).map((k) => ({ tick: 5 * k, at: 20 + k, ships }));
    expect(provenances(predictor, anew, 14).slice(2)).toEqual(Array(4).fill('confirmed'));
  });

  it('stay unknown over a reload', () => {
    const predictor = created();
    provenances(predictor, [...USUAL, { tick: 65, at: 11.5, tickRate: 10 }]);
    const next = createPredictor({ ...OWN, defaults: { bodies: [BODY] } });
    expect(next.restore(JSON.parse(JSON.stringify(predictor.snapshot(10))), 0).ok).toBe(true);
    const later = range(1, 4).map((k) => ({ tick: 65 + 10 * k, at: 11.5 + k, tickRate: 10 }));
    expect(provenances(next, later, 1)).not.toContain('confirmed');
  });
});
