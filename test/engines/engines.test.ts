import { describe, expect, it } from 'vitest';
import { caseHashes, PINNED_HASH, trajectoryHash } from './hash';
import { describeAnswer, verdictOf } from './verdict.mjs';

describe('the hash of all trajectories', () => {
  const hashes = caseHashes();

  it('is the pinned one in this engine', () => {
    expect(trajectoryHash(hashes)).toBe(PINNED_HASH);
  });

  it('changes with one bit of one landing', () => {
    const changed = hashes.map((one, i) => (i === 7 ? { ...one, hash: one.hash ^ 1 } : one));
    expect(trajectoryHash(changed)).not.toBe(PINNED_HASH);
  });
});

describe('the verdict on the engines', () => {
  const lines = ['opening 2000 0badcafe', 'all 12345678'];
  const agreeing = ['V8', 'JavaScriptCore', 'Hermes'].map((family) => ({ family, label: 'x 1.0', lines }));

  it('passes when three families agree on the pinned hash', () => {
    const { summary, complaints } = verdictOf(agreeing, '12345678');
    expect(complaints).toEqual([]);
    expect(summary).toBe('3 families agree on 1 landings: V8, JavaScriptCore, Hermes');
  });

  it('names the landing that differs, and the engine', () => {
    const other = { family: 'Boa', label: 'boa 1.0', lines: ['opening 2000 0badcaff', 'all 87654321'] };
    const { complaints } = verdictOf([...agreeing, other], '12345678');
    expect(complaints).toHaveLength(1);
    expect(complaints[0]).toMatch(/^Boa .*87654321 .*opening 2000 0badcaff, not opening 2000 0badcafe/);
  });

  it.each([
    ['two families', agreeing.slice(0, 2)],
    ['two engines of a family', [...agreeing.slice(0, 2), agreeing[0]!]],
    ['a family that is missing', [...agreeing.slice(0, 2), { family: 'Hermes', missing: 'no network' }]],
    ['an answer cut short', [...agreeing.slice(0, 2), { family: 'Hermes', lines: lines.slice(0, 1) }]],
    ['a failure', [...agreeing, { family: 'Boa', failure: 'exit 1' }]],
    ['no answer at all', []],
  ])('fails with %s', (_, answers) => {
    expect(verdictOf(answers, '12345678').complaints).not.toEqual([]);
  });

  it('fails when all agree on another hash than the pinned one', () => {
    expect(verdictOf(agreeing, '12345679').complaints).toEqual([
      'test/engines/hash.ts pins 12345679, here it is 12345678',
    ]);
  });

  it('names what it skips, and why', () => {
    expect(describeAnswer({ family: 'Boa', missing: 'not installed' }, lines).line).toMatch(
      /^Boa +skipped: not installed$/,
    );
  });
});
