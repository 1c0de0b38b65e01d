import { describe, expect, it } from 'vitest';
import { CRASHED, POSITION, SHIP_STRIDE } from '../../../src/dynamics';
import { replayTo } from '../../../src/prediction/ground/trial';
import { has } from '../../../src/prediction/simulation/rings/history';
import { abandonReplay, hold, runReplays, startReplay } from '../../../src/prediction/simulation/replay';
import { realign } from '../../../src/prediction/snapshots/reconcile/realign';
import { sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;
/** Substeps of a tick. */
const SUBSTEPS = 10;

/** Two falling ships whose server states of TICK are replayed to a front `ticks` later. */
function replayed(ticks = 2) {
  const { sim, counters } = sessionAt(TICK);
  sim.frontIsStale = false;
  const other = shipAt(sim, 'other', '', 50);
  const own = shipAt(sim, 'own', '');
  own.own = true;
  sim.fleet.own = own;
  sim.front.tick = TICK + ticks;
  for (const track of [other, own]) startReplay(track, sim, TICK, track.serverRow, 0);
  const rowOf = (rows: Float64Array, track = own) => [...rows.subarray(track.at, track.at + SHIP_STRIDE)];
  return { sim, counters, own, other, rowOf };
}

describe('a replay', () => {
  it('starts at the server’s state, as a new pass', () => {
    const { sim, own, rowOf } = replayed();
    expect(own).toMatchObject({ replaying: true, replayTick: TICK, replaySubstep: 0, adoptedTick: TICK });
    expect([own.passes, own.replayPass, own.pass]).toEqual([1, 1, 0]);
    expect(rowOf(sim.fleet.replayed)).toEqual([...own.serverRow]);
    expect(has(own.history, TICK)).toBe(true);
    startReplay(own, sim, TICK, own.serverRow, 0);
    expect([own.passes, own.replayPass]).toEqual([2, 2]);
    own.mode = 'held';
    startReplay(own, sim, TICK, own.serverRow, 0);
    expect(own.mode).toBe('waiting');
  });

  it('reaches the front with the row, the previous row and the history that the dynamics give', () => {
    const { sim, counters, own, rowOf } = replayed();
    const to = { from: own.serverRow, fromTick: TICK, toTick: TICK + 2 };
    expect(runReplays(sim, 1000)).toBe(2 * 2 * SUBSTEPS);
    expect(counters.replayedSubsteps).toBe(2 * 2 * SUBSTEPS);
    expect(rowOf(sim.fleet.front)).toEqual([...replayTo(sim, own, to)]);
    expect(own).toMatchObject({ replaying: false, mode: 'stepping', pass: 1, replaySnaps: false });
    expect([TICK + 1, TICK + 2].map((tick) => has(own.history, tick))).toEqual([true, true]);
    const step = rowOf(sim.fleet.front).map((x, k) => x - rowOf(sim.fleet.previous)[k]!);
    const moved = Math.hypot(...step.slice(POSITION, POSITION + 3));
    // One substep of 0.01 s.
    expect(moved).toBeGreaterThan(0.01);
    expect(moved).toBeLessThan(0.1);
  });

  it('continues in the next frame when the budget is spent; the player’s ship comes first', () => {
    const { sim, own, other } = replayed();
    expect(runReplays(sim, 15)).toBe(15);
    expect([own.replayTick, own.replaySubstep, own.replaying]).toEqual([TICK + 1, 5, true]);
    expect([other.replayTick, other.replaySubstep]).toEqual([TICK, 0]);
    expect(runReplays(sim, 15)).toBe(15);
    expect([own.replaying, other.replayTick, other.replaySubstep]).toEqual([false, TICK + 1, 0]);
    expect(runReplays(sim, 15)).toBe(10);
    expect(other.replaying).toBe(false);
  });

  it('is complete at once for a state at the front, and waits for one beyond it', () => {
    const at = replayed(0);
    expect(runReplays(at.sim, 1000)).toBe(0);
    expect([at.own.replaying, at.own.mode]).toEqual([false, 'stepping']);
    expect(at.rowOf(at.sim.fleet.previous)).toEqual([...at.own.serverRow]);
    const beyond = replayed(-1);
    expect(runReplays(beyond.sim, 1000)).toBe(0);
    expect(beyond.own.replaying).toBe(true);
  });

  it('of a respawned ship snaps', () => {
    for (const [crashed, snaps] of [
      [1, 1],
      [0, 0],
    ] as const) {
      const { sim, own, counters } = replayed();
      sim.fleet.front[own.at + CRASHED] = crashed;
      runReplays(sim, 1000);
      expect(counters.snaps).toBe(snaps);
    }
  });

  it('can be abandoned', () => {
    const { own } = replayed();
    own.replaySnaps = true;
    abandonReplay(own);
    expect([own.replaying, own.replaySnaps]).toEqual([false, false]);
  });

  it('holds the drawn pose of a stepping ship until it completes', () => {
    const { sim, own, other } = replayed();
    hold(sim, own);
    expect([own.mode, own.picture.hasHeld]).toEqual(['waiting', true]);
    other.mode = 'waiting';
    hold(sim, other);
    expect(other.picture.hasHeld).toBe(false);
  });
});

describe('a realigned front', () => {
  const moved = (
    how: Parameters<typeof realign>[2],
    ticks = 3,
    prepare = (_: ReturnType<typeof replayed>) => {},
  ) => {
    const of = replayed(0);
    for (const track of [of.own, of.other]) abandonReplay(track);
    of.sim.frontIsStale = true;
    prepare(of);
    realign(of.sim, { tick: TICK + ticks, substep: 4 }, how);
    return of;
  };
  const RESYNC = { resync: true, stepped: false };

  it('is at the present, and its ships are replayed from the server’s state', () => {
    const { sim, own } = moved(RESYNC);
    expect([sim.front, sim.frontIsStale, sim.alpha]).toEqual([{ tick: TICK + 3, substep: 4 }, false, 1]);
    expect(own).toMatchObject({ mode: 'waiting', replaying: true, replayTick: TICK });
    expect([own.picture.hasHeld, own.picture.skipped]).toEqual([true, 0]);
  });

  it.each([
    [TICK + 3, true],
    [TICK + 4, false],
    [-1, false],
  ])('replays a ship whose server state is of tick %i: %s', (serverTick, replays) => {
    expect(moved(RESYNC, 3, ({ own }) => (own.serverTick = serverTick)).own.replaying).toBe(replays);
  });

  it('leaves sleeping ships alone, and a running replay unless the time changed', () => {
    const asleep = moved(RESYNC, 3, ({ own }) => (own.mode = 'sleeping'));
    expect([asleep.own.mode, asleep.own.replaying]).toEqual(['sleeping', false]);
    const replaying = (resync: boolean) =>
      moved({ resync, stepped: false }, 3, ({ own }) =>
        Object.assign(own, { mode: 'waiting', replaying: true, replayTick: TICK + 1 }),
      ).own.replayTick;
    expect([replaying(true), replaying(false)]).toEqual([TICK, TICK + 1]);
  });

  it('after a clock correction fades the pose over the skipped time, up to 2 s', () => {
    const skipped = (ticks: number) => moved({ resync: true, stepped: true }, ticks).own.picture.skipped;
    expect([skipped(3), skipped(19), skipped(-4), skipped(20)]).toEqual([
      expect.closeTo(0.34, 9),
      expect.closeTo(1.94, 9),
      expect.closeTo(0.36, 9),
      0,
    ]);
  });
});
