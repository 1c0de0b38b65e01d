/** Other clients' pictures against formulas, and the gauges' figures. */
import { describe, expect, it } from 'vitest';
import { createBaseline } from '../../../../src/playground/game/live/baseline';
import { createSamples, GAUGES, summarise } from '../../../../src/playground/game/samples';
import type { Diagnosis } from '../../../../src/prediction';
import type { PartialFrame, ShipState } from '../../../../src/wire';
import { crossed, makeView } from '../../../readout/views';

const near = (x: number): unknown => expect.closeTo(x, 3);

describe('the picture of another client', () => {
  const view = makeView({ clearance: 1000 });
  const luna = view.bodies[view.own.body]!;
  const position = [1_800_000, -300_000, 250_000] as const;
  const velocity = [3, -5, 700] as const;
  const state = {
    shipId: 'ship-1',
    surfaceContactState: '',
    relativePosition: position,
    relativeVelocity: velocity,
    attitude: [0.1, 0.2, 0.3, 0.9],
  } as unknown as ShipState;

  /** Where the player's ship is drawn `seconds` after the frame, from its centre. */
  function drawn(
    mode: 'gravity' | 'last' | 'predicted',
    seconds: number,
    changes: object = {},
    frame: object = {},
  ) {
    const baseline = createBaseline();
    const given = { ships: [{ ...state, ...changes }], timeScale: 1, paused: false, ...frame };
    baseline.take(given as unknown as PartialFrame, 100);
    const seen = makeView({ clearance: 1000 });
    seen.own.legCompression.fill(0.2);
    const before = [...seen.own.meshPosition];
    baseline.redraw({ ...seen, ships: [seen.own] }, mode, 100 + seconds);
    expect(seen.own.easedPosition).toEqual(seen.own.meshPosition);
    return { at: [...seen.own.meshPosition], before, own: seen.own };
  }

  // Half of g t² towards the centre, g = G M / r².
  const range = Math.hypot(...position);
  const gravity = (6.6743e-11 * luna.mass) / range ** 2;
  const falling = (seconds: number) =>
    position.map((x, k) => near(x + velocity[k]! * seconds - (gravity * seconds ** 2 * x) / (2 * range)));
  const turning = (seconds: number) => {
    const carried = crossed([...luna.angularVelocity], position);
    return position.map((x, k) => near(x + carried[k]! * seconds));
  };

  it('falls as under the gravity of the last state, faster with the time scale, not in a pause', () => {
    expect(drawn('gravity', 20).at).toEqual(falling(20));
    expect(drawn('gravity', 5, {}, { timeScale: 4 }).at).toEqual(falling(20));
    expect(drawn('gravity', 20, {}, { timeScale: undefined }).at).toEqual(falling(20));
    expect(drawn('gravity', 20, {}, { paused: true }).at).toEqual(falling(0));
  });

  it('stays on the turning ground on it, and where it holds the last state', () => {
    expect(drawn('last', 20).at).toEqual(turning(20));
    expect(drawn('gravity', 20, { surfaceContactState: 'landed' }).at).toEqual(turning(20));
    expect([...drawn('last', 20).own.meshAttitude]).toEqual([0.1, 0.2, 0.3, 0.9]);
    expect([...drawn('last', 20).own.legCompression]).toEqual([0, 0, 0, 0]);
  });

  it('is relative to the body if the server sends ICRF positions only', () => {
    const far = { relativePosition: null, relativeVelocity: null };
    const body = { name: luna.name, position: [7, -8, 9], velocity: [1, 2, -3] };
    const moved = {
      ...far,
      position: position.map((x, k) => x + body.position[k]!),
      velocity: velocity.map((v, k) => v + body.velocity[k]!),
    };
    expect(drawn('gravity', 20, moved, { bodies: [{ ...body, name: 'Earth' }, body] }).at).toEqual(
      falling(20),
    );
    expect(drawn('gravity', 20, { ...far, position, velocity }).at).toEqual(falling(20));
    expect(drawn('gravity', 20, { ...moved, relativePosition: position }, { bodies: [body] }).at).toEqual(
      falling(20),
    );
  });

  it('is the predictor’s own in its mode, for a ship without a state, and after it is forgotten', () => {
    const own = drawn('predicted', 20);
    expect(own.at).toEqual(own.before);
    const other = drawn('last', 20, { shipId: 'another' });
    expect(other.at).toEqual(other.before);
    const baseline = createBaseline();
    baseline.take({ ships: [state] } as unknown as PartialFrame, 100);
    baseline.forget();
    const seen = makeView();
    const before = [...seen.own.meshPosition];
    baseline.redraw(seen, 'last', 101);
    expect([...seen.own.meshPosition]).toEqual(before);
  });
});

describe('the gauges', () => {
  const diagnosisOf = (value: number) =>
    Object.fromEntries(GAUGES.map(({ name }) => [name, value])) as unknown as Diagnosis;

  it('are sampled ten times a second, in their units, and restart when time goes back', () => {
    const samples = createSamples();
    const taken = [5, 5.05, 5.125, 5.15, 4, 4.125].map((now) => samples.take(diagnosisOf(0.5), now));
    expect(taken).toEqual([true, false, true, false, true, true]);
    expect(samples.times()).toEqual([5, 5.125, 4, 4.125]);
    const [degrees, ms] = [(0.5 * 180) / Math.PI, 500];
    expect(GAUGES.map((_, i) => samples.values(i)[0])).toEqual([
      ...[ms, ms, ms, ms, 0.5, 0.5, degrees, 0.5, degrees],
    ]);
    samples.clear();
    expect([samples.times(), samples.take(diagnosisOf(1), 4.126), samples.times()]).toEqual([
      [],
      true,
      [4.126],
    ]);
  });

  it('keep the last thirty seconds, oldest first', () => {
    const samples = createSamples();
    for (let i = 0; i < 307; i++) samples.take(diagnosisOf(i), i / 8);
    expect([samples.times().length, samples.times()[0], samples.times().at(-1)]).toEqual([
      300,
      7 / 8,
      306 / 8,
    ]);
    expect([samples.values(4)[0], samples.values(4).at(-1)]).toEqual([7, 306]);
  });

  it('are summarised: last, mean, the value that 95 % do not exceed, largest', () => {
    const hundred = Array.from({ length: 100 }, (_, i) => 100 - i);
    expect(summarise(hundred)).toEqual({ last: 1, mean: 50.5, p95: 95, max: 100 });
    expect(summarise([3, NaN, -1, Infinity])).toEqual({ last: -1, mean: 1, p95: 3, max: 3 });
    expect(summarise([NaN])).toEqual({ last: NaN, mean: NaN, p95: NaN, max: NaN });
  });
});
