import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import type { WorldView } from '../../../src/prediction';
import { NETWORK_PRESETS, type NetworkPreset } from '../../../src/scenarios';
import { createFaultyLine, type FaultyLine, type FaultyLineOptions, instantOf } from './faultyLine';

/** Median time by which the view is ahead of the server, s. */
function usualLead(line: FaultyLine, seconds: number): number {
  const leads: number[] = [];
  line.run(seconds, (view) => leads.push(instantOf(view) - line.serverNow()));
  return leads.sort((a, b) => a - b)[Math.floor(leads.length / 2)]!;
}

/** Frames marked confirmed beyond the newest state + interval + lead. */
function isFalselyConfirmed(line: FaultyLine, view: WorldView, interval: number): boolean {
  const reach = line.newestFrame + interval + view.diagnosis.lead + 0.05;
  return view.own?.provenance === 'confirmed' && instantOf(view) > reach;
}

interface Case {
  readonly name: string;
  readonly network: NetworkPreset;
  readonly tickRate: number;
  readonly seconds: number;
  readonly options?: Partial<FaultyLineOptions>;
  readonly happen: (line: FaultyLine, seconds: number) => void;
  /** The page's clock jumps by this, s. */
  readonly grain?: number;
}

const hold = (ways: 'up' | 'down' | 'both') => (line: FaultyLine, seconds: number) => {
  line.holdLink(seconds, ways);
  line.run(seconds);
};
const freeze = (line: FaultyLine, seconds: number) => {
  line.freezePage(seconds);
};
const pause = (answers: boolean) => (line: FaultyLine, seconds: number) => {
  line.pauseServer(seconds, answers);
  line.run(seconds);
};
const jump = (line: FaultyLine, seconds: number) => {
  const { pageClock } = line;
  line.pageClock = (now) => pageClock(now) + seconds;
};

const CASES: readonly Case[] = [
  { name: 'both ways held', network: 'broadband', tickRate: 1, seconds: 3, happen: hold('both') },
  { name: 'both ways held', network: 'broadband', tickRate: 20, seconds: 5, happen: hold('both') },
  { name: 'the way down held', network: 'fourG', tickRate: 5, seconds: 3, happen: hold('down') },
  { name: 'the way up held', network: 'fourG', tickRate: 20, seconds: 3, happen: hold('up') },
  { name: 'the page frozen', network: 'broadband', tickRate: 20, seconds: 30, happen: freeze },
  {
    name: 'the page frozen',
    network: 'lan',
    tickRate: 1,
    seconds: 600,
    happen: freeze,
    options: { drift: 5e-4 },
  },
  {
    name: 'the server standing, pings answered',
    network: 'broadband',
    tickRate: 1,
    seconds: 2.5,
    happen: pause(true),
  },
  {
    name: 'the server standing, pings not answered',
    network: 'satellite',
    tickRate: 5,
    seconds: 2.5,
    happen: pause(false),
  },
  { name: 'now put on', network: 'lan', tickRate: 1, seconds: 7, happen: jump },
  { name: 'now put back', network: 'broadband', tickRate: 20, seconds: -7, happen: jump },
  {
    name: 'both ways held, a coarse clock',
    network: 'broadband',
    tickRate: 20,
    seconds: 3,
    happen: hold('both'),
    grain: 0.1,
  },
  {
    name: 'both ways held, a clock that drifts',
    network: 'lan',
    tickRate: 20,
    seconds: 60,
    happen: hold('both'),
    options: { drift: -5e-4 },
  },
  {
    name: 'both ways held, no pings answered',
    network: 'broadband',
    tickRate: 1,
    seconds: 3,
    happen: hold('both'),
    options: { answersPings: false },
  },
  {
    name: 'the server standing, no pings ever answered',
    network: 'broadband',
    tickRate: 1,
    seconds: 2.5,
    happen: pause(false),
    options: { answersPings: false },
  },
];

describe('the clock when the network, the server or the page stalls', () => {
  it.each(CASES)('$name for $seconds s, $network, $tickRate Hz: right after 1 s or two ticks', (one) => {
    const { grain = 0, tickRate } = one;
    const line = createFaultyLine({
      network: NETWORK_PRESETS[one.network],
      tickRate,
      seed: 5,
      ...one.options,
    });
    if (grain > 0) line.pageClock = (now) => Math.floor(now / grain + 1e-9) * grain;
    line.run(8);
    const before = usualLead(line, 4);
    one.happen(line, one.seconds);
    const tolerance = (one.network === 'lan' ? 0.01 : 0.05) + grain;
    line.run(Math.max(1, 2 / tickRate) + 0.35);
    let worst = 0;
    let falselyConfirmed = 0;
    line.run(15, (view) => {
      worst = Math.max(worst, Math.abs(instantOf(view) - line.serverNow() - before));
      if (isFalselyConfirmed(line, view, 1 / tickRate)) falselyConfirmed += 1;
    });
    expect(worst).toBeLessThan(tolerance);
    expect(falselyConfirmed).toBe(0);
  });

  it('applies a key as promptly after a stall as before it', () => {
    const line = createFaultyLine({
      network: NETWORK_PRESETS.broadband,
      tickRate: 1,
      seed: 2,
      options: {},
    } as never);
    line.run(8);
    const press = () => {
      line.controls = { ...NEUTRAL_CONTROLS, attitudeHold: !line.controls.attitudeHold };
      const pressedAt = line.serverNow();
      line.run(1.2);
      const { record } = line.inputs.at(-1)!;
      return record.tick + record.substep / 100 - pressedAt;
    };
    const before = press();
    hold('both')(line, 3);
    line.run(1);
    const after = press();
    expect(line.inputs).toHaveLength(2);
    expect(Math.abs(after - before)).toBeLessThan(1.05);
  });

  it('draws no further ahead of the last frame than its horizon, and marks it stale', () => {
    const line = createFaultyLine({ network: NETWORK_PRESETS.broadband, tickRate: 20, seed: 3 });
    line.run(5);
    line.holdLink(60, 'both');
    line.run(1);
    let stale = 0;
    let frames = 0;
    let ahead = 0;
    line.run(58, (view) => {
      frames += 1;
      if (view.own!.provenance === 'stale') stale += 1;
      ahead = Math.max(ahead, instantOf(view) - line.newestFrame);
    });
    expect(stale).toBe(frames);
    expect(ahead).toBeLessThanOrEqual(5 + 1e-6);
  });

  it('distinguishes a paused server, a stalled link and a server that is gone', () => {
    const line = createFaultyLine({ network: NETWORK_PRESETS.broadband, tickRate: 1, seed: 4 });
    expect(line.predictor.view(0).connection).toBe('waiting');
    line.run(5);
    expect(line.predictor.view(line.now).connection).toBe('live');
    line.pauseServer(20, true);
    line.run(10);
    expect(line.predictor.view(line.now).connection).toBe('serverPaused');
    line.run(15);
    expect(line.predictor.view(line.now).connection).toBe('live');
    line.holdLink(30, 'both');
    line.run(5);
    expect(line.predictor.view(line.now).connection).toBe('stalled');
    line.run(15);
    expect(line.predictor.view(line.now).connection).toBe('gone');
    line.run(12);
    expect(line.predictor.view(line.now).connection).toBe('live');
  });
});
