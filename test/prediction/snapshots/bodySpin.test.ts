import { describe, expect, it } from 'vitest';
import { flyCase } from '../../bench/netcode/foreign/foreign';
import { spread } from '../../bench/netcode/figure';
import { CASES } from '../literalServer/cases';
import { createRig } from '../rig';

const caseNamed = (name: string) => CASES.find((one) => one.name === name)!;

describe('a body whose true spin differs by 1 % from the sent one', () => {
  it.each([
    ['spin 1 % off, attitudes true', 10],
    ['spin 1 % off, attitudes made of it', 10],
    ['spin 1 % off, attitudes true', 1],
    ['spin 1 % off, attitudes made of it', 1],
  ])('%s, sent at %i Hz: within 0.2 m (p95) from the third landed state on', (name, sends) => {
    const { ours } = flyCase(caseNamed(name), 50, sends);
    expect(ours.settled.length).toBeGreaterThan(200);
    expect(spread(ours.settled).p95).toBeLessThan(0.2);
  });

  it('no spin correction is made for a server that sends the true spin', () => {
    const rig = createRig({ scenario: 'slide-mars', tickRate: 5 });
    rig.fly(18);
    expect(rig.view().own!.surfaceContactState).toBe('landed');
    expect(rig.view().diagnosis.correctionsMismatch).toBe(0);
    expect(rig.view().diagnosis.correctionsBody).toBe(0);
  });
});
