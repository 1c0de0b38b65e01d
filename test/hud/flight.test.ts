/** The flight instruments: texts and pictures for given numbers (HUD, Flight instruments). */
import { expect, it } from 'vitest';
import { createFlightHud, type FlightPanels } from '../../src/hud';
import {
  createFlightReadout,
  createLandingAids,
  createTargetReadout,
  type FlightReadout,
  type LandingAids,
  type TargetReadout,
} from '../../src/readout';
import { all, attributes, changesBy, createPage, one, shownText } from './pageInNode';

interface Numbers extends Partial<Pick<FlightPanels, 'autopilot' | 'aidsOn'>> {
  readonly flight?: Partial<FlightReadout>;
  readonly aids?: Partial<LandingAids>;
  readonly target?: Partial<TargetReadout>;
}

/** What is not given is as in a new readout. */
const panelsOf = ({ flight, aids, target, autopilot = false, aidsOn = true }: Numbers): FlightPanels => ({
  flight: { ...createFlightReadout(), ...flight },
  aids: { ...createLandingAids(), ...aids },
  target: { ...createTargetReadout(), ...target },
  ...{ autopilot, aidsOn },
});

/** The HUD and readers of what it shows. */
function createHud(keyLabel?: (key: string) => string) {
  const { document, root } = createPage();
  const hud = createFlightHud(document, root, keyLabel ? { keyLabel } : {});
  return {
    show: (numbers: Numbers) => hud.paint(panelsOf(numbers)),
    text: (name: string) => shownText(one(root, name)),
    attributes: (name: string, ...names: string[]) => attributes(one(root, name), ...names),
    parts: (name: string) => all(root, name),
  };
}

const FLYING = { known: true, throttle: 0.5, hover: 0.25, fuel: 2000, fuelShare: 0.25 };

it('shows dashes for what is unknown', () => {
  const { show, text, attributes, parts } = createHud();
  expect(attributes('td-lever', 'aria-valuenow')).toEqual(['0']);
  show({ aidsOn: false });
  expect(attributes('td-lever', 'role', 'aria-label', 'aria-valuemin', 'aria-valuemax')).toEqual([
    ...['meter', 'Throttle', '0', '100'],
  ]);
  expect(attributes('td-lever', 'aria-valuenow', 'aria-valuetext')).toEqual(['0', '--']);
  expect(attributes('td-lever-fill', 'd')).toEqual(['M0 100H18V100H0Z']);
  expect(attributes('td-lever-hover', 'data-shown', 'transform')).toEqual(['false', 'translate(0 100)']);
  expect(attributes('td-ball', 'data-known')).toEqual(['false']);
  expect(text('td-attitude-words')).toBe('HDG -- PITCH --');
  expect(text('td-fuel')).toBe('FUEL -- OF TANK -- LASTS -- Δv --');
  expect([text('td-aids'), text('td-approach')]).toEqual(['', '']);
  expect(parts('kbd').map(shownText).join('')).toBe('');
});

it('shows throttle, the throttle that hovers, and fuel', () => {
  const { show, text, attributes } = createHud();
  show({ flight: { ...FLYING, burnSeconds: 83, deltaV: 1500 } });
  expect(attributes('td-lever-fill', 'd')).toEqual(['M0 50H18V100H0Z']);
  expect(attributes('td-lever-hover', 'data-shown', 'transform')).toEqual(['true', 'translate(0 75)']);
  expect(attributes('td-lever', 'aria-valuenow', 'aria-valuetext')).toEqual(['50', '50 %']);
  expect(text('td-lever-words')).toBe('ENGINE 50 % HOVER 25 %');
  expect(text('td-fuel')).toBe('FUEL 2\u202f000 kg OF TANK 25 % LASTS 83.0 s Δv 1\u202f500 m/s');
  const lows = [0.05, 0.049, NaN].map((fuelShare) => {
    show({ flight: { ...FLYING, hover: 1, fuelShare } });
    return attributes('td-fuel', 'data-low')[0];
  });
  expect(lows).toEqual(['false', 'true', 'false']);
  expect(attributes('td-lever-hover', 'data-shown', 'transform')).toEqual(['true', 'translate(0 0)']);
  show({ flight: { ...FLYING, throttle: 0.503, hover: 1.01 } });
  expect(attributes('td-lever-fill', 'd')).toEqual(['M0 50H18V100H0Z']);
  expect(attributes('td-lever-hover', 'data-shown')).toEqual(['false']);
  expect(attributes('td-lever-way', 'x', 'y', 'width', 'height')).toEqual(['0', '0', '18', '100']);
});

it('shows attitude: the zenith away from the lean, heading, pitch and the fullest wheel', () => {
  const { show, text, attributes, parts } = createHud();
  const flight = { ...FLYING, leanX: 9.7, leanY: 18.4, heading: 47, pitch: 60 };
  show({ flight: { ...flight, wheels: Float64Array.of(-0.5, 0.25, -0.75) } });
  expect(attributes('td-zenith', 'transform')).toEqual(['translate(-4.5 8)']);
  expect(attributes('td-ball', 'data-known')).toEqual(['true']);
  expect(text('td-attitude-words')).toBe('HDG 047° PITCH 60.0° WHEELS 75 %');
  // 90° of lean is the rim: rings at 15° and 45°.
  const ringsAndRim = [...parts('td-ring'), one(parts('td-attitude')[0]!, 'td-rim')];
  expect(ringsAndRim.map((ring) => Number(ring.getAttribute('r')).toFixed(9))).toEqual(
    [15, 45, 90].map((degrees) => ((40 * degrees) / 90).toFixed(9)),
  );
  for (const k of [0, 1, 2]) {
    show({ flight: { ...flight, wheels: new Float64Array(3).fill(-0.6, k, k + 1) } });
    expect(text('td-attitude-words'), `wheel ${String(k)}`).toMatch(/WHEELS 60 %$/);
  }
});

it('shows the modes with their keys, on or off in a word', () => {
  const { show, attributes, parts } = createHud((key) => (key === 'modeHold' ? '' : key.slice(0, 5)));
  const rows = () => parts('td-mode').map(shownText);
  const on = () =>
    parts('td-mode')
      .filter((row) => row.getAttribute('data-on') === 'true')
      .map((row) => shownText(one(row, 'td-mode-word')));
  const damped = { ...FLYING, damping: true };
  show({ flight: { ...damped, mode: 'radial' } });
  expect(attributes('td-modes', 'aria-label')).toEqual(['Attitude modes']);
  expect(rows()).toEqual([
    ...['rateD Damping on', 'Hold off', 'modeU Upright on', 'modeR Retrograde off', 'autop Autopilot off'],
    'killR Kill rates',
  ]);
  expect(on()).toEqual(['Damping', 'Upright']);
  const seen = (['hold', 'retrograde', 'surface_retrograde', 'prograde'] as const).map((mode) => {
    show({ flight: { ...FLYING, damping: false, mode } });
    return on();
  });
  expect(seen).toEqual([['Hold'], ['Retrograde'], ['Retrograde'], []]);
  show({ flight: { ...damped, mode: 'radial' }, autopilot: true });
  expect(on()).toEqual(['Damping', 'Autopilot']);
  show({ flight: { ...damped, mode: 'radial', known: false }, autopilot: true });
  expect(on()).toEqual([]);
});

it('shows the landing aids, late braking marked', () => {
  const { show, text, parts } = createHud();
  const aids = { aimSpeed: 5, touchSeconds: 12, touchVertical: 3, touchHorizontal: 1 };
  const late = [1, 0.9, NaN].map((burnSeconds) => {
    show({ aids: { ...aids, corridor: 'fast', burnSeconds } });
    return one(parts('td-reading-brake')[0]!, 'td-value').getAttribute('data-late');
  });
  expect(late).toEqual(['false', 'true', 'false']);
  show({ aids: { ...aids, corridor: 'fast', burnSeconds: 0.9 } });
  expect(text('td-aids')).toBe(
    'AIM ↓ 5.0 m/s TOO FAST BRAKE IN 0.9 s TOUCH IN 12.0 s AT ↓ 3.0 m/s · 1.0 m/s',
  );
  const words = (['slow', 'good', 'fast', 'none'] as const).map((corridor) => {
    show({ aids: { ...aids, corridor } });
    return `${parts('td-corridor')[0]!.getAttribute('data-corridor')!}: ${text('td-corridor')}`;
  });
  expect(words).toEqual(['slow: slow', 'good: on speed', 'fast: TOO FAST', 'none: ']);
  show({ aids, aidsOn: false });
  expect(text('td-aids')).toBe('');
});

it('shows the beacon, the drift of five seconds and the predicted touch', () => {
  const { show, text, attributes, parts } = createHud();
  const beacon = { shown: true, x: 31, y: -40, distance: 50.6, radius: 20, scale: 100 };
  const moving = { driftX: 2, driftY: -1, missX: 5, missY: 10 };
  show({ target: { ...beacon, ...moving } });
  expect(text('td-approach')).toBe('BEACON 50.6 m behind right');
  // 40 units are 100 m.
  expect(attributes('td-pad', 'cx', 'cy', 'r')).toEqual(['12.5', '16', '8']);
  expect(attributes('td-drift-way', 'd')).toEqual(['M0 0L4 2']);
  expect(attributes('td-touch-cross', 'data-shown', 'transform')).toEqual(['true', 'translate(14.5 12)']);
  expect(attributes('td-approach', 'role', 'aria-label', 'aria-valuemin', 'aria-valuemax')).toEqual([
    ...['meter', 'Distance to the beacon', '0', '100'],
  ]);
  expect(attributes('td-approach', 'aria-valuenow', 'aria-valuetext')).toEqual([
    '51',
    '50.6 m, behind right',
  ]);
  expect(one(parts('td-approach')[0]!, 'td-rim').getAttribute('r')).toBe('40');
  show({ target: { ...beacon, ...moving, missX: NaN } });
  expect(attributes('td-touch-cross', 'data-shown')).toEqual(['false']);
  show({ target: { ...beacon, ...moving }, aidsOn: false });
  expect(attributes('td-touch-cross', 'data-shown')).toEqual(['false']);
  const far = { x: -900, y: 900, distance: 1273, radius: 900, driftX: 99, driftY: 99 };
  show({ target: { ...beacon, ...far, missX: -5, missY: 5 } });
  expect(attributes('td-pad', 'cx', 'cy', 'r')).toEqual(['-40', '-40', '40']);
  expect(attributes('td-drift-way', 'd')).toEqual(['M0 0L40 -40']);
  expect(attributes('td-touch-cross', 'transform')).toEqual(['translate(-40 -40)']);
  expect(attributes('td-approach', 'aria-valuemax')).toEqual(['1273']);
  show({ target: { ...beacon, shown: false } });
  expect(text('td-approach')).toBe('');
});

it.each([
  [0, 50, 3, 'ahead'],
  [0, -50, 3, 'behind'],
  [50, 20, 3, 'right'],
  [50, -20, 3, 'right'],
  [-50, 21, 3, 'ahead left'],
  [-20, 50, 3, 'ahead'],
  [20, 50, 3, 'ahead'],
  [21, -50, 3, 'behind right'],
  [50, 0, 50, 'below you'],
  [50, 0, 49, 'right'],
])('a beacon at %d m right, %d m up on the screen, of radius %d m, is %s', (x, y, radius, way) => {
  const { show, text, attributes } = createHud();
  show({ target: { shown: true, x, y, distance: 50, radius, scale: 100, driftX: 0, driftY: 0 } });
  expect(text('td-way')).toBe(way);
  // A pad of 1.2 units would not be seen: at least 3.
  expect(attributes('td-pad', 'r')).toEqual([radius === 3 ? '3' : String(Math.round(radius * 0.8) / 2)]);
});

it.each([
  [1, 1, 'ahead right'],
  [-1, -1, 'behind left'],
])('a beacon at %d m right, %d m up is %s also where that is near', (x, y, way) => {
  const { show, text } = createHud();
  show({ target: { shown: true, x, y, distance: 1.4, radius: 0.5, scale: 10, driftX: 0, driftY: 0 } });
  expect(text('td-way')).toBe(way);
});

it('rewrites the beacon’s text only where its distance or its direction changes', () => {
  const { show, attributes } = createHud();
  const target = { shown: true, x: 0, y: 50, distance: 50, radius: 3, scale: 100, driftX: 0, driftY: 0 };
  const spoken = [target, { ...target, y: -50 }, { ...target, y: -50, distance: 51 }].map((each) => {
    show({ flight: FLYING, target: each });
    return attributes('td-approach', 'aria-valuetext')[0];
  });
  expect(spoken).toEqual(['50.0 m, ahead', '50.0 m, behind', '51.0 m, behind']);
  const last = { flight: FLYING, target: { ...target, y: -50, distance: 51 } };
  expect(changesBy(() => show(last))).toBe(0);
  expect(changesBy(() => show({ ...last, flight: { ...FLYING, throttle: 0.5001 } }))).toBe(0);
});
