/** Edge cases of timeline and event ledger. */
import { describe, expect, it } from 'vitest';
import { EVENT_CONTACT } from '../../../src/dynamics';
import { confirm, createLedger, predict } from '../../../src/prediction/events/ledger';
import { createTimeline, setTempo, writeMoment } from '../../../src/prediction/time/timeline';

const tempo = (tickRate: number, paused = false) => ({ tickRate, timeScale: 1, paused });

function momentAt(timeline: ReturnType<typeof createTimeline>, wall: number) {
  const moment = { tick: 0, substeps: 0 };
  writeMoment(moment, timeline, wall);
  return moment;
}

describe('the moment of a wall time', () => {
  it('is extrapolated back at the first tick rate', () => {
    const timeline = createTimeline(0.01);
    setTempo(timeline, 5, tempo(1), 100);
    expect(momentAt(timeline, 98.25)).toEqual({ tick: 3, substeps: 25 });
  });

  it('stays at the first tick of a later rate until that rate begins', () => {
    const timeline = createTimeline(0.01);
    setTempo(timeline, 5, tempo(1), 100);
    setTempo(timeline, 8, tempo(2), 200);
    expect(momentAt(timeline, 102.5)).toEqual({ tick: 7, substeps: 50 });
    expect(momentAt(timeline, 103.5)).toEqual({ tick: 8, substeps: 0 });
    expect(momentAt(timeline, 150)).toEqual({ tick: 8, substeps: 0 });
    expect(momentAt(timeline, 200)).toEqual({ tick: 8, substeps: 0 });
    expect(momentAt(timeline, 200.75)).toEqual({ tick: 9, substeps: 25 });
  });
});

describe('the nearest event of the same type', () => {
  const at = (tick: number, substep: number) => ({ tick, substep });
  function twoTouches() {
    const timeline = createTimeline(0.01);
    setTempo(timeline, 0, tempo(1), 0);
    const ledger = createLedger('s');
    predict(ledger, EVENT_CONTACT, at(3, 20), timeline, 0);
    predict(ledger, EVENT_CONTACT, at(3, 60), timeline, 0);
    return { timeline, ledger };
  }

  it('is confirmed whether earlier or later, the earlier of two at equal distance', () => {
    for (const [substep, found] of [
      [25, 0],
      [55, 1],
      [40, 0],
    ] as const) {
      const { timeline, ledger } = twoTouches();
      confirm(ledger, EVENT_CONTACT, at(3, substep), timeline);
      expect(ledger.entries.map(({ status: fate }) => fate).indexOf('confirmed'), `at ${substep}`).toBe(
        found,
      );
      expect(ledger.entries).toHaveLength(2);
    }
  });

  it('counts as the same event up to 50 substeps away, and as another beyond', () => {
    const { timeline, ledger } = twoTouches();
    confirm(ledger, EVENT_CONTACT, at(4, 10), timeline);
    expect(ledger.entries).toHaveLength(2);
    const other = twoTouches();
    confirm(other.ledger, EVENT_CONTACT, at(4, 11), other.timeline);
    expect(other.ledger.entries).toHaveLength(3);
  });
});
