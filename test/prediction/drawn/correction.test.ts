import { describe, expect, it } from 'vitest';
import { ATTITUDE, POSITION, REFERENCE_BODY, VELOCITY } from '../../../src/dynamics';
import {
  captureDrawn,
  easeCorrection,
  fadeFromHeld,
  holdDrawn,
  POLICY_STALL,
} from '../../../src/prediction/drawn/correction';
import { LONG_AGO } from '../../../src/prediction/drawn/picture';
import { pose } from '../../../src/prediction/drawn/pose';
import { setTempo } from '../../../src/prediction/time/timeline';
import { turnAbout } from '../../dynamics/vectors';
import { RATE, sessionAt, shipAt } from '../decisions/sessionAt';

const TICK = 100;
const STYLE = { snaps: false, uprights: false };
/** Along (2, −3, 6), whose length is 7. */
const along = (metres: number) => [2, -3, 6].map((part) => (part * metres) / 7);

/** A ship in step at its server state of TICK, which is the present, at rest. */
function drawn() {
  const { sim } = sessionAt(TICK);
  const track = shipAt(sim, 'own', '');
  setTempo(sim.timeline, TICK, { tickRate: RATE, timeScale: 1, paused: false }, 0);
  for (const rows of [sim.fleet.front, sim.fleet.previous])
    rows.fill(0, track.at + VELOCITY, track.at + VELOCITY + 3);
  const place = (move: readonly number[]) => {
    for (const rows of [sim.fleet.front, sim.fleet.previous])
      for (const [k, x] of move.entries()) rows[track.at + POSITION + k]! += x;
  };
  const speed = (metresPerSecond: number) => sim.fleet.front.set(along(metresPerSecond), track.at + VELOCITY);
  return { sim, track, place, speed, ease: track.picture.ease };
}
type Drawn = ReturnType<typeof drawn>;

/** Whether a correction by `metres` is eased; `prepare` before it, `change` with it. */
function isEased(metres: number, prepare: (of: Drawn) => void = () => {}, change = prepare, style = STYLE) {
  const of = drawn();
  prepare(of);
  const before = captureDrawn(of.sim, of.track);
  of.place(along(metres));
  if (change !== prepare) change(of);
  easeCorrection(of.sim, of.track, before, style);
  expect(of.ease.active).toBe(of.sim.counters.snaps === 0 && before.known);
  return of.ease.active;
}

describe('a correction', () => {
  it('leaves the drawn pose in place: the offset is what the prediction moved', () => {
    const { sim, track, place, ease } = drawn();
    const before = captureDrawn(sim, track);
    place(along(7));
    easeCorrection(sim, track, before, STYLE);
    expect(Math.hypot(...ease.offset)).toBeCloseTo(7, 6);
    const again = captureDrawn(sim, track);
    place(along(7));
    easeCorrection(sim, track, again, STYLE);
    expect(Math.hypot(...ease.offset)).toBeCloseTo(14, 6);
    expect(sim.counters.snaps).toBe(0);
  });

  it('is eased up to 25 m; a larger one snaps, and is counted', () => {
    expect([isEased(24.9), isEased(25.1)]).toEqual([true, false]);
  });

  it('is eased up to 60°', () => {
    const turned = (degrees: number) =>
      isEased(
        0,
        ({ sim, track }) => {
          for (const rows of [sim.fleet.front, sim.fleet.previous])
            rows.set([0, 0, 0, 1], track.at + ATTITUDE);
        },
        ({ sim, track }) => {
          const turn = turnAbout([0, 0, 1], (degrees * Math.PI) / 180);
          for (const rows of [sim.fleet.front, sim.fleet.previous]) rows.set(turn, track.at + ATTITUDE);
        },
      );
    expect([turned(59), turned(61)]).toEqual([true, false]);
  });

  it('is eased up to 25 m plus the distance flown since the last server state', () => {
    const silent = (of: Drawn) => {
      of.speed(10);
      of.track.silence = 3;
    };
    expect([isEased(54.9, silent), isEased(55.1, silent)]).toEqual([true, false]);
    const skipped = (of: Drawn) => {
      silent(of);
      of.track.picture.skipped = 4;
    };
    expect([isEased(64.9, skipped), isEased(65.1, skipped)]).toEqual([true, false]);
    // By the faster of the speeds before and after.
    const stopped = (of: Drawn) => of.speed(0);
    expect(isEased(54.9, silent, stopped)).toBe(true);
    expect(
      isEased(
        54.9,
        (of) => (of.track.silence = 3),
        (of) => of.speed(10),
      ),
    ).toBe(true);
    const fast = (of: Drawn) => {
      silent(of);
      setTempo(of.sim.timeline, TICK, { tickRate: RATE, timeScale: 2, paused: false }, 0);
    };
    expect([isEased(84.9, fast), isEased(85.1, fast)]).toEqual([true, false]);
  });

  it('is eased up to 25 m plus the distance from that state to the present', () => {
    const ahead = (of: Drawn) => {
      of.speed(10);
      of.sim.front.tick = TICK + 20;
      of.sim.front.substep = 5;
    };
    // 2.05 s at 10 m/s.
    expect([isEased(45.4, ahead), isEased(45.6, ahead)]).toEqual([true, false]);
    const behind = (of: Drawn) => {
      of.speed(10);
      of.sim.front.tick = TICK - 20;
    };
    expect([isEased(24.9, behind), isEased(25.1, behind)]).toEqual([true, false]);
  });

  it('of a ship that respawned, or is at another body, snaps', () => {
    expect(
      isEased(
        1,
        () => {},
        () => {},
        { snaps: true, uprights: false },
      ),
    ).toBe(false);
    const elsewhere = ({ track, sim }: Drawn) => {
      const before = captureDrawn(sim, track);
      before.body = 1;
      easeCorrection(sim, track, before, STYLE);
      return track.picture.ease.active;
    };
    expect(elsewhere(drawn())).toBe(false);
  });

  it('of a ship that was not drawn is not eased', () => {
    const { sim, track, place, ease } = drawn();
    track.mode = 'waiting';
    const before = captureDrawn(sim, track);
    place(along(7));
    easeCorrection(sim, track, before, STYLE);
    expect([ease.active, sim.counters.snaps]).toEqual([false, 0]);
  });

  it('clears the held pose and the skipped time, and notes an uprighting', () => {
    const { sim, track } = drawn();
    holdDrawn(sim, track);
    expect(track.picture.hasHeld).toBe(true);
    track.picture.skipped = 3;
    easeCorrection(sim, track, captureDrawn(sim, track), { snaps: false, uprights: true });
    expect(track.picture).toMatchObject({ hasHeld: false, skipped: 0, sinceUprighting: 0 });
    expect(track.picture.body).toBe(sim.fleet.front[track.at + REFERENCE_BODY]);
    easeCorrection(sim, track, captureDrawn(sim, track), STYLE);
    expect(track.picture.sinceUprighting).toBe(LONG_AGO);
  });

  it('of a held ship is eased from the held pose', () => {
    const { sim, track, place, ease } = drawn();
    holdDrawn(sim, track);
    const held = [...track.picture.heldPlace];
    expect(Math.hypot(...held)).toBeCloseTo(
      Math.hypot(...sim.fleet.front.subarray(track.at + POSITION, track.at + POSITION + 3)),
      6,
    );
    track.mode = 'waiting';
    place(along(7));
    easeCorrection(sim, track, captureDrawn(sim, track), STYLE);
    expect(Math.hypot(...ease.offset)).toBeCloseTo(7, 6);
  });
});

describe('a change of policy', () => {
  const faded = (metres: number, prepare: (of: Drawn) => void = () => {}) => {
    const of = drawn();
    const { sim, track } = of;
    holdDrawn(sim, track);
    track.serverRow.fill(0, VELOCITY, VELOCITY + 3);
    prepare(of);
    const seen = pose();
    seen.position.set([...track.picture.heldPlace].map((x, k) => x + along(metres)[k]!));
    seen.attitude.set(track.picture.heldAttitude);
    fadeFromHeld(sim, track, seen);
    expect([...track.picture.heldPlace]).toEqual([...seen.position]);
    expect(track.picture.hasHeld).toBe(false);
    return track.picture.ease.active;
  };

  it('fades from the pose drawn before it, up to 25 m', () => {
    expect([faded(24.9), faded(25.1)]).toEqual([true, false]);
  });

  it('fades over up to two seconds of flight more', () => {
    const moving = ({ track }: Drawn) => track.serverRow.set(along(10), VELOCITY);
    const most = 25 + 10 * POLICY_STALL;
    expect([faded(most - 0.1, moving), faded(most + 0.1, moving)]).toEqual([true, false]);
    const fast = (of: Drawn) => {
      moving(of);
      setTempo(of.sim.timeline, TICK, { tickRate: RATE, timeScale: 2, paused: false }, 0);
    };
    expect([faded(64.9, fast), faded(65.1, fast)]).toEqual([true, false]);
  });

  it('snaps to another body', () => {
    expect(faded(1, ({ track }) => (track.serverRow[REFERENCE_BODY] = 1))).toBe(false);
  });

  it('of a ship that is not held only keeps its pose', () => {
    const { sim, track, ease } = drawn();
    const seen = pose();
    seen.position.set([1, 2, 3]);
    seen.attitude.set([0, 1, 0, 0]);
    fadeFromHeld(sim, track, seen);
    expect([...track.picture.heldPlace, ...track.picture.heldAttitude]).toEqual([1, 2, 3, 0, 1, 0, 0]);
    expect(ease.active).toBe(false);
  });
});
