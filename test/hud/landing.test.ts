/** The landing HUD: what it prints, draws and announces for given numbers (HUD, The landing HUD and Access). */
import { describe, expect, it } from 'vitest';
import type { LandingReadout } from '../../src/readout';
import { createLandingHud } from './landingHudInNode';
import { all, changesBy, shownText } from './pageInNode';

const near = (x: number): unknown => expect.closeTo(x, 1);

const ANGLES = { settle: 5, noReturn: 37, tipped: 80 };

describe('the status', () => {
  it('is renewed where its provenance, age, time scale or status alone changes', () => {
    const { show, text, attributes } = createLandingHud();
    const seen = (
      [
        { status: 'flight', provenance: 'predicted', age: 0.3 },
        { status: 'contact', provenance: 'predicted', age: 0.3 },
        { status: 'contact', provenance: 'predicted', age: 0.4 },
        { status: 'contact', provenance: 'confirmed', age: 0.4 },
        { status: 'contact', provenance: 'off', age: 0.4, timeScale: 100 },
        { status: 'contact', provenance: 'off', age: 0.4, timeScale: 50 },
        { status: 'contact', provenance: 'stale', age: 2.6 },
      ] as const
    ).map((numbers) => {
      show(numbers);
      return `${attributes('td-provenance', 'data-provenance')[0]!}: ${text('td-provenance')}`;
    });
    expect(seen).toEqual([
      ...['predicted: PRED', 'predicted: PRED 0.3 s', 'predicted: PRED 0.4 s', 'confirmed: CONF 0.4 s'],
      ...['off: PRED OFF ×100', 'off: PRED OFF ×50', 'stale: STALE 2.6 s'],
    ]);
  });

  it('names a retracted prediction while the readout has one', () => {
    const { show, text } = createLandingHud();
    const shown = (['', 'landed', ''] as const).map((withdrawn) => {
      show({ withdrawn });
      return text('td-withdrawn');
    });
    expect(shown).toEqual(['', 'LANDED withdrawn', '']);
  });

  it('pulses once when a ground state begins, never at the first status or for flight', () => {
    const { show, attributes } = createLandingHud();
    const pulses = (['contact', 'contact', 'landed', 'flight', 'contact', 'none', 'tipped'] as const).map(
      (status) => {
        show({ status });
        return attributes('td-status', 'data-pulse')[0];
      },
    );
    // 'a' and 'b' are the same animation: another name restarts it.
    expect(pulses).toEqual([null, null, 'a', 'a', 'b', 'b', 'b']);
    const { show: showNext, attributes: next } = createLandingHud();
    for (const status of ['flight', 'contact'] as const) showNext({ status, known: true });
    expect(next('td-status', 'data-pulse', 'data-known', 'data-colour')).toEqual(['a', 'true', 'yellow']);
  });

  it('is announced once when the server has confirmed it, TIPPED and CRASHED as alerts', () => {
    const { root, show } = createLandingHud();
    const regions = all(root, 'td-unseen').filter(({ localName }) => localName === 'p');
    expect(regions.map((region) => region.getAttribute('role'))).toEqual(['status', 'alert']);
    const told = (status: LandingReadout['status'], provenance: LandingReadout['provenance']) => {
      show({ shipName: 'Kestrel', status, provenance });
      return regions.map((region) => region.textContent).join('|');
    };
    expect(told('flight', 'confirmed')).toBe('|');
    expect(told('contact', 'predicted')).toBe('|');
    expect(told('contact', 'confirmed')).toBe('Kestrel: contact|');
    expect(told('tipped', 'off')).toBe('Kestrel: contact|');
    expect(told('tipped', 'confirmed')).toBe('|Kestrel: tipped');
    expect(told('none', 'confirmed')).toBe('|Kestrel: tipped');
    expect(told('landed', 'confirmed')).toBe('Kestrel: landed|');
    const again = () => show({ shipName: 'Kestrel', status: 'landed', provenance: 'confirmed' });
    expect(changesBy(again)).toBe(0);
    expect(told('crashed', 'confirmed')).toBe('|Kestrel: crashed');
  });

  it('is announced at once on a page that opens with a ship that has tipped', () => {
    const { root, show } = createLandingHud();
    show({ shipName: 'Kestrel', status: 'tipped', provenance: 'confirmed' });
    expect(all(root, 'td-unseen').map((region) => region.textContent)).toContain('Kestrel: tipped');
  });
});

describe('the tilt', () => {
  it('is a meter before and after its first number', () => {
    const { show, attributes, text } = createLandingHud();
    const meter = () => attributes('td-tilt-gauge', 'aria-valuenow', 'aria-valuetext', 'data-known');
    expect(attributes('td-tilt-gauge', 'role', 'aria-label', 'aria-valuemin', 'aria-valuemax')).toEqual([
      ...['meter', 'Tilt', '0', '180'],
    ]);
    expect(meter()).toEqual(['0', null, null]);
    show({});
    expect([meter(), text('td-tilt-value')]).toEqual([['0', 'not known', 'false'], '--']);
    show({ tilt: { degrees: 7.5, ...ANGLES } });
    expect([meter(), text('td-tilt-value')]).toEqual([['8', '8.0° of tilt', 'true'], '7.5°']);
    show({});
    expect(meter()).toEqual(['0', 'not known', 'false']);
  });

  it('turns the needle as the ship leans, to the end of the dial', () => {
    const { show, attributes } = createLandingHud();
    const needle = (degrees: number) => {
      show({ tilt: { degrees, ...ANGLES } });
      return /rotate\((.*)\)/.exec(attributes('td-needle', 'transform')[0]!)![1];
    };
    expect([0, 45, 96, 96.4, 178].map(needle)).toEqual(['0', '45', '96', '96', '96']);
    expect(needle(NaN)).toBe('0');
  });

  it('marks where the ship settles, is past return and has tipped, at true angles about the needle’s pivot', () => {
    const { show, parts } = createLandingHud();
    expect(parts('td-mark-text').map(shownText)).toEqual(['', '', '']);
    show({ tilt: { degrees: 3, ...ANGLES } });
    expect(parts('td-mark-text').map(shownText)).toEqual(['5°', '37°', '80°']);
    const at = (degrees: number, radius: number) => {
      const radians = (degrees * Math.PI) / 180;
      return [28 + radius * Math.sin(radians), 100 - radius * Math.cos(radians)];
    };
    const places = (element: Element, name: string) =>
      element
        .getAttribute(name)!
        .match(/-?[\d.]+/g)!
        .map(Number);
    parts('td-mark').forEach((mark, i) => {
      const angle = [5, 37, 80][i]!;
      const ends = [...at(angle, 71), ...at(angle, 85)];
      expect(places(mark, 'd'), `mark at ${String(angle)}°`).toEqual(ends.map(near));
      const label = at(angle, 94).map(near);
      expect(places(parts('td-mark-text')[i]!, 'transform'), `label at ${String(angle)}°`).toEqual(label);
    });
    // On a steep slope the mark of no return comes near one of the others: two labels would overlap.
    const labelled = (noReturn: number) => {
      show({ tilt: { degrees: 3, ...ANGLES, noReturn } });
      return parts('td-mark-text').map(shownText);
    };
    expect([11, 20, 70].map(labelled)).toEqual([
      ['', '11°', '80°'],
      ['5°', '20°', '80°'],
      ['5°', '', '80°'],
    ]);
    show({ tilt: { degrees: 3, ...ANGLES } });
    const zones = parts('td-zone').slice(1);
    expect(zones.map((zone) => zone.getAttribute('class'))).toEqual(
      ['settled', 'leaning', 'toppling', 'tipped'].map((zone) => `td-zone td-zone-${zone}`),
    );
    const arcs = (ends: readonly (readonly [number, number])[]) =>
      ends.map(([from, to]) => [...at(from, 79), 79, 79, 0, 0, 1, ...at(to, 79)]).flat();
    const drawn = zones.flatMap((zone) => places(zone, 'd'));
    const expected = arcs([
      [0, 5],
      [5, 37],
      [37, 80],
      [80, 96],
    ]);
    expect(drawn).toEqual(expected.map(near));
    // A ship that is past return only after it has tipped rocks back until then; one that is so before it settles never does.
    for (const [noReturn, leaning] of [[85, 80] as const, [3, 5] as const]) {
      show({ tilt: { degrees: 3, ...ANGLES, noReturn } });
      const ends = arcs([
        [5, leaning],
        [leaning, 80],
      ]);
      const both = parts('td-zone').slice(2, 4);
      expect(both.flatMap((zone) => places(zone, 'd'))).toEqual(ends.map(near));
    }
  });

  it.each([
    [{ degrees: NaN, trend: 1 }, 'none: '],
    [{ degrees: 3, trend: 0 }, '0: steady'],
    [{ degrees: 3, trend: 1 }, '1: leaning over'],
    [{ degrees: 3, trend: -1 }, '-1: coming up'],
  ] as const)('has a trend in words: %o is %s', (tilt, words) => {
    const { show, attributes, text } = createLandingHud();
    show({ tilt: { ...tilt, prominent: true } });
    expect(`${attributes('td-trend', 'data-trend')[0]!}: ${text('td-trend')}`).toBe(words);
    expect(attributes('td-tilt', 'data-prominent')).toEqual(['true']);
  });

  it.each([
    [{ shown: false }, 'none: '],
    [{ outlook: 'steady', degrees: 24.46 }, 'steady: 24.5° to tip'],
    [{ outlook: 'steady', degrees: 0.4 }, 'steady: 0.4° to tip'],
    [{ outlook: 'working', degrees: 0 }, 'working: 0.0° to tip'],
    [{ outlook: 'holds', degrees: 0.5 }, 'holds: 0.5° to tip'],
    [{ outlook: 'holds', degrees: -0.04 }, 'holds: past, but held'],
    [{ outlook: 'working', degrees: -3 }, 'working: past the point of no return'],
    [{ outlook: 'tips', degrees: -3, timeToTipped: 4.2 }, 'tips: tips in 4.2 s'],
    [{ outlook: 'tips', degrees: 3, timeToTipped: 0.4 }, 'tips: tips in 0.4 s'],
  ] as const)('has a margin in words: %o is %s', (margin, words) => {
    const { show, attributes, text } = createLandingHud();
    const line = () => `${attributes('td-margin', 'data-outlook')[0]!}: ${text('td-margin')}`;
    show({ margin: { shown: true, ...margin } });
    expect(line()).toBe(words);
    show({ margin: { shown: true, outlook: 'steady', degrees: 12 } });
    expect(line()).toBe('steady: 12.0° to tip');
    show({ margin: { shown: true, ...margin } });
    expect(line()).toBe(words);
  });
});

it.each([
  [{ verticalSpeed: 12.3 }, 'down', '↓ 12.3 m/s 4.0 m/s 5.2 s 85.8 m'],
  [{ verticalSpeed: -0.06, timeToImpact: NaN }, 'up', '↑ 0.1 m/s 4.0 m/s -- 85.8 m'],
  [{ verticalSpeed: 0.04 }, 'none', '0.0 m/s 4.0 m/s 5.2 s 85.8 m'],
  [{ shown: false, verticalSpeed: 12.3 }, 'none', '-- -- -- --'],
])('the descent of %o points %s and reads %s', (change, arrow, words) => {
  const { show, attributes, text, parts } = createLandingHud();
  expect(attributes('td-arrow', 'data-arrow')).toEqual(['none']);
  expect(text('td-descent')).toMatch(/^VSPD (-- )?HSPD -- TTI -- AGL --$/);
  const descent = { shown: true, horizontalSpeed: 4, timeToImpact: 5.2, feetHeight: 85.8 };
  show({ descent: { ...descent, ...change } });
  expect(attributes('td-arrow', 'data-arrow')).toEqual([arrow]);
  expect(text('td-arrow')).toBe({ down: '↓', up: '↑', none: '' }[arrow]);
  expect(parts('td-value').slice(0, 4).map(shownText).join(' ')).toBe(words);
  expect(attributes('td-descent', 'data-shown')).toEqual(['shown' in change ? 'false' : 'true']);
});

it('the touchdown card shows the outcome, only for a touchdown of the status shown', () => {
  const { show, text } = createLandingHud();
  const touchdown = {
    ...{ verticalSpeed: 12.3, horizontalSpeed: 4.9, bounces: 1 },
    ...{ slideMetres: 15.2, settleSeconds: 8.4, largestTilt: 9 },
  };
  show({ status: 'landed', touchdown, touchdownShown: true });
  expect(text('td-landed')).toBe('Landed');
  expect(text('td-touchdown')).toBe(
    'TOUCHDOWN Vertical 12.3 m/s Horizontal 4.9 m/s Bounces 1 Slide 15.2 m To rest 8.4 s Largest tilt 9.0°',
  );
  show({ status: 'contact', touchdown, touchdownShown: false });
  expect([text('td-landed'), text('td-touchdown')]).toEqual(['', '']);
});
