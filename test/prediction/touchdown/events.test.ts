import { describe, expect, it } from 'vitest';
import { EVENT_CONTACT, EVENT_LANDED } from '../../../src/dynamics';
import {
  confirm,
  confirmByState,
  createLedger,
  predict,
  retract,
} from '../../../src/prediction/events/ledger';
import { createTimeline, setTempo } from '../../../src/prediction/time/timeline';
import { NO_TOUCHDOWN } from '../../readout/views';
import { createRig } from '../rig';

function ledgerAt(tickRate = 1) {
  const timeline = createTimeline(0.01);
  setTempo(timeline, 0, { tickRate, timeScale: 1, paused: false }, 0);
  return { timeline, ledger: createLedger('s') };
}

const at = (tick: number, substep: number) => ({ tick, substep });

describe('the event ledger of one ship', () => {
  it('reports a predicted event once, however often it is replayed and wherever within 50 substeps', () => {
    const { ledger, timeline } = ledgerAt();
    expect(predict(ledger, EVENT_CONTACT, at(3, 40), timeline, 0)).toMatchObject({
      kind: 'predicted',
      tick: 3,
    });
    expect(predict(ledger, EVENT_CONTACT, at(3, 41), timeline, 1)).toBeNull();
    expect(predict(ledger, EVENT_CONTACT, at(3, 90), timeline, 2)).toBeNull();
    expect(predict(ledger, EVENT_CONTACT, at(4, 41), timeline, 3)).toMatchObject({ tick: 4, substep: 41 });
  });

  it('keeps two touches of one pass apart, even within 50 substeps', () => {
    const { ledger, timeline } = ledgerAt();
    expect(predict(ledger, EVENT_CONTACT, at(3, 40), timeline, 0)).not.toBeNull();
    expect(predict(ledger, EVENT_CONTACT, at(3, 60), timeline, 0)).not.toBeNull();
    expect(predict(ledger, EVENT_CONTACT, at(3, 42), timeline, 1)).toBeNull();
    expect(predict(ledger, EVENT_CONTACT, at(3, 62), timeline, 1)).toBeNull();
  });

  it('keeps 64 unsettled events at most, and reports none of them again at a replay', () => {
    const { ledger, timeline } = ledgerAt();
    const reported = (pass: number) =>
      Array.from({ length: 100 }, (_, tick) => predict(ledger, EVENT_CONTACT, at(tick, 0), timeline, pass));
    expect(reported(0).filter((notice) => notice !== null)).toHaveLength(64);
    expect(reported(1).filter((notice) => notice !== null)).toEqual([]);
    expect(ledger.entries).toHaveLength(64);
    // One that the server has sent takes the place of the oldest.
    expect(confirm(ledger, EVENT_LANDED, at(500, 0), timeline)).toMatchObject({ tick: 500 });
    expect(ledger.entries).toHaveLength(64);
    expect(ledger.entries[0]).toMatchObject({ tick: 1 });
  });

  it('confirms the nearest event of the type once, and moves it to the server’s substep', () => {
    const { ledger, timeline } = ledgerAt(20);
    predict(ledger, EVENT_CONTACT, at(30, 2), timeline, 0);
    predict(ledger, EVENT_LANDED, at(31, 0), timeline, 0);
    expect(confirm(ledger, EVENT_CONTACT, at(35, 2), timeline)).toMatchObject({
      kind: 'confirmed',
      type: 'ship.contact',
      ...at(35, 2),
    });
    expect(confirm(ledger, EVENT_CONTACT, at(35, 2), timeline)).toBeNull();
    expect(ledger.entries).toHaveLength(2);
    // An event that the server sent first is not reported again when the client predicts it.
    confirm(ledger, EVENT_CONTACT, at(60, 0), timeline);
    expect(predict(ledger, EVENT_CONTACT, at(60, 1), timeline, 0)).toBeNull();
  });

  it('retracts with the first frame that covers the predicted substep + 50, and not before', () => {
    const { ledger, timeline } = ledgerAt();
    predict(ledger, EVENT_LANDED, at(3, 40), timeline, 0);
    predict(ledger, EVENT_LANDED, at(5, 60), timeline, 0);
    expect(retract(ledger, 3, timeline)).toBeNull();
    expect(retract(ledger, 4, timeline)).toMatchObject({ kind: 'retracted', tick: 3, substep: 40 });
    expect(retract(ledger, 4, timeline)).toBeNull();
    expect(retract(ledger, 6, timeline)).toBeNull();
    expect(retract(ledger, 7, timeline)).toMatchObject({ tick: 5, substep: 60 });
    // Predicted again, it is a new event.
    expect(predict(ledger, EVENT_LANDED, at(3, 41), timeline, 1)).toMatchObject({ kind: 'predicted' });
  });

  it('confirms by state when a server sends no events', () => {
    const { ledger, timeline } = ledgerAt();
    predict(ledger, EVENT_CONTACT, at(3, 40), timeline, 0);
    predict(ledger, EVENT_LANDED, at(3, 90), timeline, 0);
    expect(confirmByState(ledger, 4, 'contact', false)).toMatchObject({ type: 'ship.contact' });
    expect(confirmByState(ledger, 4, 'contact', false)).toBeNull();
    expect(confirmByState(ledger, 5, 'landed', false)).toMatchObject({ type: 'ship.landed' });
  });
});

describe('a prediction that the server contradicts', () => {
  it('CONTACT and LANDED are withdrawn by the first frame that covers them, and shown as withdrawn for 2 s', () => {
    const rig = createRig({ scenario: 'settle' });
    rig.fly(1.3);
    // An operator lifts the ship between two frames: it does not touch where the client predicts.
    const up = rig.view().own!.serverPosition;
    const far = Math.sqrt(up.reduce((sum, x) => sum + x * x, 0));
    rig.authority.kick('ship-1', [(8 * up[0]!) / far, (8 * up[1]!) / far, (8 * up[2]!) / far], [0, 0, 0]);
    let landedShown = 0;
    let told = 0;
    let shownAfter = 0;
    rig.fly(5, ({ own }) => {
      if (own!.shownState === 'landed') landedShown += 1;
      if (own!.withdrawn !== 'landed') return;
      told += 1;
      if (own!.shownState === 'landed') shownAfter += 1;
    });
    const heard = rig.notices.map(({ kind, type }) => `${kind} ${type}`);
    expect(heard.slice(0, 4)).toEqual([
      'predicted ship.contact',
      'predicted ship.landed',
      'retracted ship.contact',
      'retracted ship.landed',
    ]);
    expect(landedShown).toBeGreaterThan(2);
    expect(told).toBe(120);
    expect(shownAfter).toBe(0);
    expect(rig.view().diagnosis.correctionsMismatch).toBe(1);
  });
});

it('a touchdown is blank before the first touch, and is timed from it', () => {
  const rig = createRig({ scenario: 'settle' });
  let [flying, open] = [0, 0];
  rig.fly(2, ({ own }) => {
    if (own === null) return;
    const { touchdown, surfaceContactState } = own;
    if (!touchdown.known) expect(touchdown).toEqual(NO_TOUCHDOWN);
    else if (surfaceContactState !== '') expect(touchdown.settleSeconds).toBeGreaterThan(0);
    if (surfaceContactState === '') flying += 1;
    else open += 1;
  });
  expect(flying).toBeGreaterThan(20);
  expect(open).toBeGreaterThan(5);
});
