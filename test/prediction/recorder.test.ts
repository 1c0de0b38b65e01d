import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { hashRows } from '../../src/dynamics';
import { createPredictor, type PredictorEntry, recordPredictor, replayEntries } from '../../src/prediction';
import { readRecording, writeRecording } from '../../src/scenarios';
import { flyPilot } from '../bench/netcode/law';
import { createRig, value } from './rig';

describe('the recorder', () => {
  it('writes what a new predictor needs to do the same again, to the bit, through a file of JSON lines', () => {
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
    const twin = createPredictor({ terrains: { [rig.loaded.scenario.terrain]: rig.loaded.terrainHeight } });
    let replayed = 0;
    replayEntries(twin, read.entries, (at) => {
      const { own } = twin.view(at);
      if (own !== null)
        replayed = hashRows(Float64Array.of(replayed, ...own.easedPosition, ...own.meshAttitude));
    });
    expect(flown).not.toBe(0);
    expect(replayed).toBe(flown);
  });
});

describe('own inputs that come late', () => {
  it('are corrected, and every correction says why', () => {
    const { rig } = flyPilot(2, 0.3);
    const { diagnosis } = rig.view();
    expect(rig.authority.counters.inputsLate).toBeGreaterThan(2);
    expect(diagnosis.correctionsLateInput).toBeGreaterThan(2);
    expect(diagnosis.correctionsMismatch).toBe(0);
    expect(diagnosis.correctionsOtherPilot).toBe(0);
    expect(diagnosis.margin).not.toBe(0);
  });
});

describe('the page for a cockpit developer', () => {
  it('quotes example code that compiles: the regions of example.ts, word for word', () => {
    const page = readFileSync('src/prediction/README.md', 'utf8');
    const example = readFileSync('test/prediction/example.ts', 'utf8');
    const regions = [...example.matchAll(/\/\/ #region \w+\n([\s\S]*?)\/\/ #endregion/g)];
    expect(regions).toHaveLength(3);
    for (const [, code] of regions) expect(page).toContain(code!.trim());
  });
});
