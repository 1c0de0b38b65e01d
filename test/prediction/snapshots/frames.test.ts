import { describe, expect, it } from 'vitest';
import type { ServerFrame, ServerMessage, ShipState } from '../../../src/wire';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { corrections, flyAndMeasure } from '../measure';
import { createRig, type Rig } from '../rig';
import { distance } from '../samples';

/** Replaces each frame by those that `change` returns. */
function tamperFrames(rig: Rig, change: (frame: ServerFrame) => readonly ServerMessage[]): void {
  const { tamper } = rig;
  rig.tamper = (message) =>
    message.kind === 'frame' ? change(message).flatMap((m) => tamper(m)) : tamper(message);
}

function withShip(frame: ServerFrame, change: (ship: ShipState) => Partial<ShipState>): ServerFrame {
  return { ...frame, ships: frame.ships.map((ship) => ({ ...ship, ...change(ship) })) };
}

/** The ship moved by `metres` along its local up: a state that the law does not lead to. */
function lifted(frame: ServerFrame, metres: number): ServerFrame {
  return withShip(frame, ({ relativePosition, position }) => {
    const r = relativePosition!;
    const share = metres / Math.sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    const moved = (v: readonly number[]) => v.map((x, k) => x + r[k]! * share) as [number, number, number];
    return { relativePosition: moved(r), position: moved(position) };
  });
}

describe('imperfect frame delivery', () => {
  it('counts duplicates and frames out of order, and ignores them', () => {
    const rig = createRig({ scenario: 'bounce' });
    let kept: ServerFrame | null = null;
    tamperFrames(rig, (frame) => {
      if (frame.tick % 4 === 1) {
        kept = frame;
        return [];
      }
      if (frame.tick % 4 === 2 && kept !== null) return [frame, kept, frame, kept];
      return [frame, frame];
    });
    const measured = flyAndMeasure(rig, 16);
    const { diagnosis } = rig.view();
    expect(diagnosis.framesOutOfOrder).toBeGreaterThan(2);
    expect(diagnosis.framesDuplicate).toBeGreaterThan(10);
    expect(corrections(rig)).toBe(0);
    expect(measured.worst).toBeLessThan(1e-6);
  });

  it('counts frames from the distant past and future, and ignores them', () => {
    const rig = createRig({ scenario: 'bounce' });
    const kept: ServerFrame[] = [];
    tamperFrames(rig, (frame) => {
      kept.push(frame);
      const future = lifted({ ...frame, tick: frame.tick + 1000 * (1 + (frame.tick % 3)) }, 500);
      const past = kept.length > 15 ? [lifted(kept[0]!, 500)] : [];
      return frame.tick % 2 === 0 ? [future, frame, ...past] : [frame];
    });
    const measured = flyAndMeasure(rig, 24);
    const { diagnosis } = rig.view();
    expect(diagnosis.framesFromFuture).toBeGreaterThan(8);
    expect(diagnosis.framesTooOld).toBeGreaterThan(2);
    expect(corrections(rig)).toBe(0);
    expect(measured.worst).toBeLessThan(1e-6);
  });

  it('accepts another time once a second frame confirms it', () => {
    const rig = createRig({ scenario: 'bounce' });
    rig.fly(4);
    tamperFrames(rig, (frame) => [{ ...frame, tick: frame.tick + 100_000 }]);
    rig.fly(4);
    expect(rig.view().tick).toBeGreaterThan(100_000);
    expect(rig.view().diagnosis.framesFromFuture).toBe(1);
    expect(rig.view().diagnosis.resyncs).toBeGreaterThan(0);
    expect(Number.isFinite(rig.view().own!.easedPosition[0]!)).toBe(true);
  });

  it('refuses a frame with tick rate or time scale out of range, and keeps the last good state', () => {
    const rig = createRig({ scenario: 'settle' });
    rig.fly(3);
    const before = [...rig.view().own!.position];
    rig.predictor.receive({ ...frameOf(rig), tickRate: Number.NaN }, rig.now);
    rig.predictor.receive({ ...frameOf(rig), tick: -3 }, rig.now);
    rig.predictor.refused('frame.ships[0].fuel: expected a finite number');
    const { diagnosis } = rig.view();
    expect(diagnosis.framesRefused).toBe(3);
    expect(diagnosis.lastRefusal).toMatch(/^frame\.ships\[0\]\.fuel/);
    expect([...rig.view().own!.position]).toEqual(before);
  });

  it('draws a ship of an unknown class from its states, and names the class', () => {
    const rig = createRig({ scenario: 'settle', others: 2 });
    tamperFrames(rig, (frame) => [
      {
        ...frame,
        ships: frame.ships.map((ship) => (ship.shipId === 'other-1' ? { ...ship, shipClass: 'ufo' } : ship)),
      },
    ]);
    rig.fly(3);
    const drawn = rig.view().ships.map(({ shipId, provenance }) => [shipId, provenance === 'off']);
    expect(drawn).toEqual([
      ['ship-1', false],
      ['other-1', true],
      ['other-2', false],
    ]);
    expect(rig.view().diagnosis.lastRefusal).toBe('frame.ships (other-1): shipClass: no class named ufo');
  });

  it('accepts quaternions of either sign', () => {
    const rig = createRig({ scenario: 'topple' });
    tamperFrames(rig, (frame) => [
      frame.tick % 2 === 0
        ? frame
        : withShip(frame, ({ attitude: [x, y, z, w] }) => ({ attitude: [-x, -y, -z, -w] })),
    ]);
    const measured = flyAndMeasure(rig, 10);
    expect(corrections(rig)).toBe(0);
    expect(measured.worst).toBeLessThan(1e-6);
  });
});

describe('corrections', () => {
  it('two in one display frame: the newer one applies', () => {
    const rig = createRig({ scenario: 'bounce' });
    const waiting: ServerFrame[] = [];
    tamperFrames(rig, (frame) => {
      if (frame.tick < 4 || frame.tick > 6) return [frame];
      waiting.push(lifted(frame, frame.tick === 4 ? 2 : 3));
      return frame.tick === 5 ? waiting : frame.tick === 6 ? [frame] : [];
    });
    rig.fly(9);
    const { diagnosis } = rig.view();
    // Frames of ticks 4 and 5 at once; tick 6 brings the ship back.
    expect(diagnosis.correctionsMismatch).toBe(3);
    expect(flyAndMeasure(rig, 3).worst).toBeLessThan(1e-6);
  });

  it('a deeper one after a shallower one: the shallower, newer one applies', () => {
    const rig = createRig({ scenario: 'bounce' });
    let late: ServerFrame | null = null;
    tamperFrames(rig, (frame) => {
      if (frame.tick === 4) {
        late = lifted(frame, 3);
        return [];
      }
      if (frame.tick === 5) return [lifted(frame, 2), late!];
      return [frame];
    });
    rig.fly(5.5);
    expect(rig.view().diagnosis.correctionsMismatch).toBe(1);
    expect(rig.view().diagnosis.framesOutOfOrder).toBe(1);
    rig.fly(3);
    expect(rig.view().diagnosis.correctionsMismatch).toBe(2);
    expect(flyAndMeasure(rig, 3).worst).toBeLessThan(1e-6);
  });

  it('one that the budget spreads over several frames survives the frames between', () => {
    const rig = createRig({ scenario: 'bounce', others: 60, predictor: { maxSubstepsPerFrame: 400 } });
    rig.fly(12);
    const { diagnosis, ships } = rig.view();
    expect(ships).toHaveLength(61);
    expect(diagnosis.correctionsMismatch).toBe(0);
    expect(flyAndMeasure(rig, 4).worst).toBeLessThan(1e-6);
  });

  it('one during the easing of another: nothing drawn jumps', () => {
    const rig = createRig({ scenario: 'bounce', tickRate: 5 });
    rig.fly(3);
    tamperFrames(rig, (frame) => [lifted(frame, frame.tick % 2 === 0 ? 0.9 : -0.6)]);
    let before: number[] | null = null;
    let largest = 0;
    let corrected = 0;
    rig.fly(2, (view) => {
      const { own, diagnosis } = view;
      const drawn = [...own!.easedPosition];
      if (before !== null) {
        const moved = distance(drawn, before);
        const speed = Math.sqrt(own!.velocity.reduce((sum, v) => sum + v * v, 0));
        largest = Math.max(largest, moved - speed / 60);
      }
      before = drawn;
      corrected = diagnosis.correctionsMismatch;
    });
    expect(corrected).toBeGreaterThan(6);
    // 8 % of overlapping corrections of up to 1.5 m, and no jump of 1.5 m.
    expect(largest).toBeLessThan(0.08 * 2.4);
  });
});

describe('a gap in the frames', () => {
  it('of a minute ends in one resync: nothing is replayed, no burst of inputs, held keys are released', () => {
    const held = { ...NEUTRAL_CONTROLS, rotationInput: [0.02, 0, 0] as const, attitudeHold: true };
    const rig = createRig({ scenario: 'bounce', pilot: () => held });
    rig.fly(4);
    const before = { ...rig.view().diagnosis };
    const hidden = rig.now + 60;
    while (rig.now < hidden) rig.receiveOnly();
    rig.frame();
    const { diagnosis } = rig.view();
    expect(diagnosis.resyncs).toBe(before.resyncs + 1);
    expect(diagnosis.replayedSubsteps - before.replayedSubsteps).toBeLessThan(300);
    expect(diagnosis.steppedSubsteps - before.steppedSubsteps).toBeLessThan(5);
    expect(rig.sentInputs.at(-1)).toMatchObject({
      controls: { rotationInput: [0, 0, 0], attitudeHold: true },
    });
    const sent = rig.sentInputs.length;
    rig.fly(2);
    expect(rig.sentInputs.length - sent).toBeLessThanOrEqual(1);
    expect(rig.view().own!.controls.rotationInput).toEqual([0, 0, 0]);
    expect(flyAndMeasure(rig, 2).worst).toBeLessThan(1e-6);
  });

  it('removes ships that are not sent for 3 ticks, except crashed ones', () => {
    const rig = createRig({ scenario: 'crash', others: 1 });
    rig.fly(3);
    expect(rig.view().ships.map(({ shipId }) => shipId)).toContain('other-1');
    rig.authority.despawn('other-1');
    rig.fly(2.3);
    const fading = rig.view().ships.find(({ shipId }) => shipId === 'other-1')!;
    expect(fading.missingSends).toBeGreaterThan(0);
    rig.fly(2.5);
    expect(rig.view().ships.map(({ shipId, shownState }) => [shipId, shownState])).toEqual([
      ['ship-1', 'crashed'],
    ]);
  });
});

function frameOf(rig: Rig): ServerFrame {
  return rig.authority.frameFor('me')!;
}
