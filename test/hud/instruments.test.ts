/** The landing HUD's dials, tables and help for given numbers (HUD, The landing HUD). */
import { describe, expect, it } from 'vitest';
import type { Gate, Righting } from '../../src/readout';
import { createLandingHud } from './landingHudInNode';
import { all, attributes, one, shownText } from './pageInNode';

describe('the cross-pointer', () => {
  const drawn = (x: number, y: number, scale: number) => {
    const hud = createLandingHud();
    hud.show({ drift: { x, y, scale } });
    const [across, along, way] = all(one(hud.root, 'td-cross'), 'path').map((path) => path.getAttribute('d'));
    return { across, along, way, dot: hud.attributes('td-cross-dot', 'transform')[0], ...hud };
  };

  it('points where the ship drifts: +X right, +Y up, full deflection at its scale', () => {
    expect(drawn(5, 2.5, 10)).toMatchObject({
      across: 'M25 -50V50',
      along: 'M-50 -12.5H50',
      way: 'M0 0L25 -12.5',
      dot: 'translate(25 -12.5)',
    });
    expect(drawn(-25, -12, 10)).toMatchObject({ across: 'M-50 -50V50', along: 'M-50 50H50' });
    expect(drawn(25, 12, 10)).toMatchObject({ across: 'M50 -50V50', along: 'M-50 -50H50' });
    const unknown = drawn(NaN, NaN, 10);
    expect(unknown).toMatchObject({ across: 'M0 -50V50', along: 'M-50 0H50' });
    expect(unknown.attributes('td-drift', 'data-known')).toEqual(['false']);
  });

  it('has rings at full and half deflection, and the letters of the axes on its rim', () => {
    const { root } = createLandingHud();
    const dial = one(one(root, 'td-drift'), 'td-dial');
    expect(['td-rim', 'td-ring'].map((name) => one(dial, name).getAttribute('r'))).toEqual(['50', '25']);
    const letters = all(dial, 'td-axis-text').map((letter) => [
      shownText(letter),
      ...attributes(letter, 'x', 'y').map(Number),
    ]);
    // Outside the rim of 50, X at its right and Y at its top.
    expect(letters).toEqual([
      ['X', 58, 4],
      ['Y', 0, -55],
    ]);
    expect(one(one(root, 'td-cross'), 'td-cross-dot').getAttribute('r')).toBe('4');
  });

  it('is a meter of the speed, with a sentence in whole metres per second', () => {
    const { show, attributes, text } = createLandingHud();
    const meter = () => attributes('td-drift', 'aria-valuenow', 'aria-valuemax', 'aria-valuetext');
    expect(attributes('td-drift', 'role', 'aria-label', 'aria-valuemin', 'aria-valuenow')).toEqual([
      ...['meter', 'Drift along the ground', '0', '0'],
    ]);
    show({});
    expect([meter(), text('td-scale')]).toEqual([['0', '1', 'not known'], '±1 m/s']);
    show({ drift: { x: 3.4, y: -3.6, scale: 5 } });
    expect([meter(), text('td-scale')]).toEqual([['5', '5', '3.0 m/s along X, −4.0 m/s along Y'], '±5 m/s']);
    show({ drift: { x: 3.4, y: -2.6, scale: 5 } });
    expect(meter()).toEqual(['4', '5', '3.0 m/s along X, −3.0 m/s along Y']);
    show({ drift: { x: -0.2, y: -2.6, scale: 5 } });
    expect(meter()).toEqual(['3', '5', '0.0 m/s along X, −3.0 m/s along Y']);
    show({ drift: { x: NaN, y: NaN, scale: 5 } });
    expect([attributes('td-drift', 'data-known'), meter()]).toEqual([['false'], ['0', '5', 'not known']]);
  });

  // Within 20° of an axis the wedge covers its letter.
  it.each([
    [0, 0, null, 'none'],
    [0, 1, 0, 'Y'],
    [Math.sin(0.34), Math.cos(0.34), 19, 'Y'],
    [Math.sin(0.36), Math.cos(0.36), 21, 'none'],
    [1, 0, 90, 'X'],
    [Math.cos(0.36), Math.sin(0.36), 69, 'none'],
    [0.94, 0.34, 70, 'none'],
    [0.34, 0.94, 20, 'none'],
    [-1, 0, -90, 'none'],
    [0, -1, 180, 'none'],
  ])('a ship whose lowest side is (%d, %d) has the wedge at %s°, over %s', (leanX, leanY, degrees, over) => {
    const { show, attributes, parts } = createLandingHud();
    show({ tilt: { leanX, leanY } });
    const turn = degrees === null ? null : `rotate(${String(degrees)})`;
    expect(attributes('td-lean', 'data-shown', 'transform')).toEqual([
      degrees === null ? 'false' : 'true',
      turn,
    ]);
    const covered = parts('td-axis-text').filter((letter) => letter.getAttribute('data-covered') === 'true');
    expect(covered.map(shownText).join('') || 'none').toBe(over);
  });
});

describe('the gates', () => {
  const gate = (value: number, limit: number, met: boolean): Gate => ({ value, limit, met });
  const level = {
    shown: true,
    onSlope: false,
    tilt: gate(7.5, 5, false),
    spin: gate(0.004, 0.01, true),
    vertical: gate(0.3, 0.5, true),
    horizontal: gate(0.75, 0.5, false),
    slope: gate(38.9, 38.7, false),
    balance: gate(12, 36.9, true),
  };

  it('give value, limit and whether it is met, the slope’s only on a slope, with what missing it leads to', () => {
    const { show, root, text } = createLandingHud();
    const rows = () => {
      const [, ...found] = all(one(root, 'td-gates'), 'tr').filter((row) => !row.hidden);
      return found.map((row) => {
        const [label] = attributes(one(row, 'td-tick'), 'aria-label');
        return `${shownText(row)} (${label!}, ${row.getAttribute('data-met')!})`;
      });
    };
    expect(text('td-gates')).toBe('');
    show({ gates: level });
    expect(shownText(one(root, 'caption'))).toBe('To count as landed, meet all of these at once');
    expect(shownText(one(root, 'thead'))).toBe('Gate Now Limit Met');
    const four = [
      'Tilt 7.5° 5.0° ✗ (not met, false)',
      'Spin 0.004 rad/s 0.010 rad/s ✓ (met, true)',
      'Vertical 0.30 m/s 0.50 m/s ✓ (met, true)',
      'Horizontal 0.75 m/s 0.50 m/s ✗ (not met, false)',
    ];
    expect(text('td-gates')).toMatch(/^To count as landed.* Tilt 7.5° 5.0° ✗ .* 0.50 m\/s ✗$/);
    expect(rows()).toEqual(four);
    show({ gates: { ...level, onSlope: true } });
    expect(rows()).toEqual([
      ...four,
      'Slope 38.9° 38.7° ✗ it slides (not met: it slides, false)',
      'Lean 12.0° 36.9° ✓ (met, true)',
    ]);
    show({ gates: { ...level, onSlope: true, slope: level.balance, balance: gate(40, 36.9, false) } });
    expect(rows().slice(4)).toEqual([
      'Slope 12.0° 36.9° ✓ (met, true)',
      'Lean 40.0° 36.9° ✗ it topples (not met: it topples, false)',
    ]);
    show({ gates: { ...level, shown: false } });
    expect(text('td-gates')).toBe('');
  });

  it('are a table with headings for its columns and rows', () => {
    const { root } = createLandingHud();
    const scopes = all(one(root, 'td-gates'), 'th').map(
      (head) => (head as unknown as { scope: string }).scope,
    );
    expect(scopes).toEqual([...Array<string>(4).fill('col'), ...Array<string>(6).fill('row')]);
    expect(all(root, 'td-tick').every((mark) => mark.getAttribute('role') === 'img')).toBe(true);
  });
});

describe('the righting help', () => {
  const able: Partial<Righting> = {
    shown: true,
    actions: ['pitchMinus'],
    possible: true,
    outcome: 'lands',
    torqueNeeded: 88_800,
    torqueAvailable: 141_000,
    fuel: 4000,
    fuelNeeded: 26.7,
    holdSeconds: 1.5,
    holdUntil: 36.87,
  };
  const keyLabel = (action: string) =>
    ({ pitchMinus: 'W', translateYPlus: 'I', rateDamping: 'T' })[action] ?? '';
  const hint = 'Use RCS rotation to right the ship';
  const torque = 'TORQUE 88.8 kN m of 141 kN m ✓';
  const damp = 'RELEASE below 36.9° then press T rate damping';
  const cannot = `${hint} TORQUE 88.8 kN m of 141 kN m ✗`;

  it.each<readonly [string, Partial<Righting>, string]>([
    ['lands', {}, `${hint} HOLD W pitch − 1.5 s ${damp} ${torque} FUEL 26.7 kg of 4\u202f000 kg ✓`],
    [
      'is still simulated',
      { outcome: 'working', fuelNeeded: NaN },
      `${hint} HOLD W pitch − ${damp} ${torque} FUEL -- of 4\u202f000 kg`,
    ],
    [
      'fails',
      { outcome: 'fails', fuelNeeded: NaN },
      `${hint} HOLD W pitch − ${damp} ${torque} FUEL -- of 4\u202f000 kg ✗ ` +
        'In simulation the ship does not stay upright: it runs out of fuel or falls over.',
    ],
    [
      'needs two keys, one unbound, with damping on',
      { actions: ['pitchMinus', 'yawPlus'], damped: true },
      `${hint} HOLD W pitch − yaw + 1.5 s RELEASE below 36.9° ${torque} FUEL 26.7 kg of 4\u202f000 kg ✓`,
    ],
    [
      'is too heavy here',
      { possible: false },
      `${cannot} It cannot be righted here: nothing on board can turn this weight.`,
    ],
    [
      'is lighter with thrusters',
      { possible: false, help: 'translation', helpAction: 'translateYPlus' },
      `${cannot} Too heavy to turn. Take weight off its feet with I thrusters +Y`,
    ],
    [
      'is lighter without fuel',
      { possible: false, help: 'lighter', helpMass: 9100 },
      `${cannot} Too heavy to turn. Burn fuel until it weighs less than 9\u202f100 kg`,
    ],
    ['is not tipped', { shown: false }, ''],
  ])('of a ship that %s', (_what, change, words) => {
    const { show, text } = createLandingHud({ keyLabel });
    show({ righting: { ...able, ...change } });
    expect(text('td-righting')).toBe(words);
  });

  it('marks what suffices in words too', () => {
    const { show, parts } = createLandingHud();
    const marks = (change: Partial<Righting>) => {
      show({ righting: { ...able, ...change } });
      return parts('td-need').map((line) => {
        const mark = attributes(one(line, 'td-tick'), 'role', 'aria-label').join(': ');
        return `${line.getAttribute('data-met')!}, ${mark}`;
      });
    };
    const [enough, not] = ['true, img: enough', 'false, img: not enough'];
    expect(marks({})).toEqual([enough, enough]);
    expect(marks({ outcome: 'working' })).toEqual([enough, 'unknown, img: not known']);
    expect(marks({ outcome: 'fails' })).toEqual([enough, not]);
    expect(marks({ possible: false })[0]).toBe(not);
  });

  it('names the page’s own controls where it has others', () => {
    const turnKeys = () => [
      { cap: '↑', words: 'tip away' },
      { cap: '', words: 'lean left' },
    ];
    const { show, text } = createLandingHud({ turnKeys });
    show({ righting: { ...able, actions: ['pitchMinus', 'yawPlus'], damped: true } });
    expect(text('td-righting')).toContain('HOLD ↑ tip away lean left 1.5 s RELEASE');
  });
});
