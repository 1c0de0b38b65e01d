import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { store } from '../../../src/prediction/inputs/inputs';
import { createSending, lastControls, takeInputs } from '../../../src/prediction/inputs/sending';
import type { ClientMessage } from '../../../src/wire';
import { sessionAt } from '../decisions/sessionAt';

/** Tick of the front; ticks are 0.1 s of ten substeps. */
const FRONT = 100;

/** What is sent at each `[wall s, tick, substep]` at which the throttle moves: `tick:substep` of each record. */
function sent(...moves: readonly (readonly [now: number, tick: number, substep: number])[]): string[] {
  const { sim } = sessionAt(FRONT);
  const sending = createSending();
  return moves.map(([now, tick, substep], i) => {
    store(sim.inputs, { ...NEUTRAL_CONTROLS, thrustLevel: i / 10 }, { tick, substep }, now, 0);
    return takeInputs(sim, sending, now)
      .map((record) => `${String(record.tick)}:${String(record.substep)}`)
      .join(' ');
  });
}

describe('a record', () => {
  it('with a stamp of its own is sent at once: another substep or another tick is another stamp', () => {
    expect(sent([0, 102, 0], [0.01, 102, 5], [0.02, 103, 5])).toEqual(['102:0', '102:5', '103:5']);
  });

  it('with the stamp of the one just sent waits half a second', () => {
    const dragged = sent([0, 102, 3], [0.1, 102, 3], [0.49, 102, 3], [0.5, 102, 3], [0.9, 102, 3]);
    expect(dragged).toEqual(['102:3', '', '', '102:3', '']);
  });

  it('waits 50 ms where its stamp is due within 100 ms', () => {
    expect(sent([0, 100, 10], [0.04, 100, 10], [0.05, 100, 10])).toEqual(['100:10', '', '100:10']);
    expect(sent([0, 101, 1], [0.05, 101, 1])).toEqual(['101:1', '']);
  });

  it('never waits where its stamp is due within two display frames', () => {
    expect(sent([0, 100, 3], [0.001, 100, 3])).toEqual(['100:3', '100:3']);
    expect(sent([0, 100, 4], [0.001, 100, 4])).toEqual(['100:4', '']);
  });
});

describe('the last controls of messages', () => {
  const inputs = (...levels: number[]): ClientMessage => ({
    kind: 'inputs',
    inputs: levels.map((thrustLevel, seq) => {
      return { seq, tick: 1, substep: 0, controls: { ...NEUTRAL_CONTROLS, thrustLevel } };
    }),
  });
  const ping: ClientMessage = { kind: 'ping', id: 1 };

  it('are those of the last record', () => {
    expect(lastControls([inputs(0.1), inputs(0.2, 0.4, 0.3), ping])?.thrustLevel).toBe(0.3);
  });

  it('are null without a record', () => {
    expect([lastControls([]), lastControls([ping]), lastControls([inputs()])]).toEqual([null, null, null]);
  });
});
