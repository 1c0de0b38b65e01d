/** Links to flights: the text of their inputs, and what is shown and copied. */
import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import { createFlightLink } from '../../../../src/playground/game/flight/flightLink';
import type { Live } from '../../../../src/playground/game/live/live';
import {
  bytesOf,
  MAX_LINK_LENGTH,
  readFlight,
  textOf,
  writeFlight,
} from '../../../../src/playground/game/mission/runText';
import { scriptOf } from '../../../../src/playground/game/live/script';
import { type Choices, DEFAULT_CHOICES, readChoices } from '../../../../src/playground/panels/choices';
import type { Recording, RunInput } from '../../../../src/scenarios';

const SUBSTEPS = scriptOf(DEFAULT_CHOICES).substeps;
const input = (tick: number, thrustLevel: number): RunInput => ({
  ...{ tick, substep: 3 },
  controls: { ...NEUTRAL_CONTROLS, thrustLevel },
});

describe('bytes as text', () => {
  it('are base64url without padding, of any length', () => {
    for (let length = 0; length < 8; length++) {
      const bytes = Uint8Array.from({ length }, (_, i) => 251 + i);
      expect(textOf(bytes)).toBe(Buffer.from(bytes).toString('base64url'));
      expect(bytesOf(textOf(bytes))).toEqual(bytes);
    }
  });

  it.each(['a+b/', 'ab==', 'ab cd', 'é', 'abcde'])('%s is refused', (text) => {
    expect(bytesOf(text)).toBeNull();
    expect(readFlight(text, SUBSTEPS)).toEqual({ ok: false, reason: 'not base64url' });
  });

  it('are at most 200,000 letters', () => {
    expect(bytesOf('A'.repeat(200_000))).toHaveLength(150_000);
    expect(bytesOf('A'.repeat(200_001))).toBeNull();
  });

  it('that are not a run are refused with the fault', () => {
    const cut = textOf(Uint8Array.of(4, 1));
    expect(readFlight(cut, SUBSTEPS)).toEqual({
      ok: false,
      reason: expect.stringMatching(/\w/) as string,
    });
    expect(readFlight(cut, SUBSTEPS)).not.toEqual({ ok: false, reason: 'not base64url' });
  });
});

describe('a flight’s link', () => {
  function open(choices: Choices = DEFAULT_CHOICES) {
    const done: string[] = [];
    const copied: { query: string; words: string }[] = [];
    const link = createFlightLink({
      live: () => ({ operate: ({ kind }: { kind: string }) => done.push(kind) }) as unknown as Live,
      choices: () => choices,
      address: {
        write: () => undefined,
        copy: (query, words) => copied.push({ query, words }),
      },
      notice: {
        show: (text) => done.push(text),
        tell: () => undefined,
        ...{ clear: () => undefined, withdraw: () => undefined, showLink: () => undefined },
      },
    });
    const flown = () => {
      const { flight } = readChoices(new URLSearchParams(copied.at(-1)!.query)).choices;
      const read = readFlight(flight, SUBSTEPS);
      return read.ok
        ? read.value.map(({ tick, controls }) => [tick, controls.thrustLevel])
        : [[read.reason, NaN]];
    };
    return { link, done, copied, flown };
  }

  it('is copied once per request', () => {
    const { link, done, copied, flown } = open();
    expect(link.take([input(2, 1)])).toBe(false);
    link.copy();
    expect(done).toEqual(['run']);
    expect(link.take([input(2, 1), input(5, 0.5)])).toBe(true);
    expect(link.take([input(2, 1)])).toBe(false);
    expect(copied.map(({ words }) => words)).toEqual(['Flight link copied.']);
    expect(flown()).toEqual([
      [2, 1],
      [5, 0.5],
    ]);
    link.copy();
    link.take([]);
    expect(copied[1]!.words).toBe('Link copied: nothing was flown by hand.');
    expect(done).toEqual(['run', 'run']);
  });

  it('continues from the flight that a link brought, from the pilot’s first input on', () => {
    const brought = writeFlight([input(1, 0.2), input(4, 0.4), input(9, 0.9)], SUBSTEPS);
    const { link, flown } = open({ ...DEFAULT_CHOICES, flight: brought });
    link.copy();
    link.take([input(4, 1)]);
    expect(flown()).toEqual([
      [1, 0.2],
      [4, 1],
    ]);
    link.copy();
    link.take([]);
    expect(flown()).toEqual([
      [1, 0.2],
      [4, 0.4],
      [9, 0.9],
    ]);
  });

  it('is reported as long from the length that mail and chat cut off', () => {
    const { link, done, copied } = open();
    const lengthOf = (count: number) => {
      done.length = 0;
      link.copy();
      link.take(Array.from({ length: count }, (_, i) => input(i + 1, (i % 2) / 2)));
      return copied.at(-1)!.query.length;
    };
    let [least, most] = [1, 10_000];
    while (most - least > 1) {
      const count = (least + most) >> 1;
      if (lengthOf(count) > MAX_LINK_LENGTH) most = count;
      else least = count;
    }
    const short = lengthOf(least);
    expect([short <= MAX_LINK_LENGTH, done]).toEqual([true, ['run']]);
    const long = lengthOf(most);
    expect(done).toEqual(['run', `This link has ${long} characters; some programs cut off links that long.`]);
  });

  it('of a recording has each input that was sent once, in the world that its note names', () => {
    const { link, copied, flown } = open();
    const sent = (seqs: readonly number[]) => ({
      kind: 'sent',
      message: { kind: 'inputs', inputs: seqs.map((seq) => ({ seq, ...input(seq, seq / 10) })) },
    });
    const entries = [sent([1, 2]), { kind: 'sent', message: { kind: 'ping' } }, sent([2, 3])];
    link.copyOf({
      header: { note: '?scenario=launch&seed=7', shipId: 'own' },
      entries,
    } as unknown as Recording);
    expect(flown()).toEqual([
      [1, 0.1],
      [2, 0.2],
      [3, 0.3],
    ]);
    expect(readChoices(new URLSearchParams(copied[0]!.query)).choices).toMatchObject({
      scenario: 'launch',
      seed: 7,
    });
  });
});
