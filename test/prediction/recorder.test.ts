import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { hashRows } from '../../src/dynamics';
import {
  createPredictor,
  type Predictor,
  type PredictorEntry,
  recordPredictor,
  replayEntries,
} from '../../src/prediction';
import { readRecording, writeRecording } from '../../src/scenarios';
import { encodeServerMessage, pendingServerMessage } from '../../src/wire';
import { flyPilot } from '../bench/netcode/flights/law';
import { createRig, value } from './rig';

describe('the recorder', () => {
  it('records what a new predictor needs to repeat every bit, through a file of JSON lines', () => {
    const entries: PredictorEntry[] = [];
    const rig = createRig({ scenario: 'right-itself', others: 2 });
    rig.predictor = recordPredictor(rig.predictor, (entry) => entries.push(entry));
    let flown = 0;
    rig.fly(14, ({ own }) => {
      if (own !== null) flown = hashRows(Float64Array.of(flown, ...own.easedPosition, ...own.meshAttitude));
    });
    const file = writeRecording({ header: { note: 'a test', shipId: 'ship-1' }, entries });
    const read = value(readRecording(file));
    expect(read.entries).toHaveLength(entries.length);
    const second = createPredictor({ terrains: { [rig.loaded.scenario.terrain]: rig.loaded.terrainHeight } });
    let replayed = 0;
    replayEntries(second, read.entries, (at) => {
      const { own } = second.view(at);
      if (own !== null)
        replayed = hashRows(Float64Array.of(replayed, ...own.easedPosition, ...own.meshAttitude));
    });
    expect(flown).not.toBe(0);
    expect(replayed).toBe(flown);
  });
});

describe('the recorder of a session with calls and undecoded messages', () => {
  it('records calls and decoded messages, so that a new predictor does the same', () => {
    const entries: PredictorEntry[] = [];
    const rig = createRig({ scenario: 'slide', others: 2, tickRate: 20 });
    rig.predictor = recordPredictor(rig.predictor, (entry) => entries.push(entry));
    const { predictor } = rig;
    rig.tamper = (message) => {
      predictor.receivePending(pendingServerMessage(encodeServerMessage(message)), rig.now);
      return [];
    };
    const flown: number[] = [];
    // The prediction only: the drawn pose also depends on when views were requested.
    const look = (predictor: Predictor, at: number, out: number[]) => {
      for (const ship of predictor.view(at).ships)
        out.push(hashRows(Float64Array.of(...ship.position, ...ship.attitude, ship.missingSends)));
    };
    for (let i = 0; i < 60 * 8; i++) {
      if (i === 120) predictor.setPolicy('ship-2', 'interpolate');
      if (i === 180) predictor.removeShip('ship-3', 'docked');
      if (i === 240) predictor.setOwnShip('ship-2');
      if (i === 260) predictor.teleported('ship-1');
      if (i === 300) predictor.reset();
      rig.frame();
      look(predictor, rig.now, flown);
      // A page that was hidden: most frames are superseded.
      if (i % 100 === 99) for (let k = 0; k < 60; k++) rig.receiveOnly();
    }
    const file = writeRecording({ header: { note: 'calls', shipId: 'ship-1' }, entries });
    const read = value(readRecording(file));
    expect(read.entries).toEqual(entries);
    expect(entries.filter(({ kind }) => kind === 'called')).toHaveLength(5);
    expect(rig.view().diagnosis.framesSuperseded).toBeGreaterThan(20);
    const { scenario, terrainHeight } = rig.loaded;
    const second = createPredictor({ terrains: { [scenario.terrain]: terrainHeight } });
    const replayed: number[] = [];
    replayEntries(second, read.entries, (at) => look(second, at, replayed));
    expect(replayed).toEqual(flown);
  });

  it('refuses an invalid call', () => {
    const call = { name: 'removeShip', shipId: 'a', reason: 'bored' };
    const header = writeRecording({ header: { note: '', shipId: 'a' }, entries: [] });
    const read = readRecording(header + JSON.stringify({ kind: 'called', at: 1, call }));
    expect(read.ok ? '' : read.reason).toContain('call.reason');
  });
});

describe('own inputs that come late', () => {
  it('are corrected, and every correction gives its reason', () => {
    const { rig } = flyPilot(2, 0.3);
    const { diagnosis } = rig.view();
    expect(rig.authority.counters.inputsLate).toBeGreaterThan(2);
    expect(diagnosis.correctionsLateInput).toBeGreaterThan(2);
    expect(diagnosis.correctionsMismatch).toBe(0);
    expect(diagnosis.correctionsOtherPilot).toBe(0);
    expect(diagnosis.margin).not.toBe(0);
  });
});

describe('the guide for cockpit developers', () => {
  it('quotes code that compiles: the regions of example.ts, word for word', () => {
    const page = readFileSync('src/prediction/README.md', 'utf8');
    const example = readFileSync('test/prediction/example.ts', 'utf8');
    const regions = [...example.matchAll(/\/\/ #region \w+\n([\s\S]*?)\/\/ #endregion/g)];
    expect(regions).toHaveLength(3);
    for (const [, code] of regions) expect(page).toContain(code!.trim());
  });
});
