/** The fleet HUD's rows (HUD, Fleet), and what all HUDs have in common: theme, layout, scrolling by keyboard, an end. */
import { describe, expect, it } from 'vitest';
import { createCockpitLandingHud, createFleetHud, createFlightHud, type HudAppearance } from '../../src/hud';
import { createFleetReadout, type FleetReadout, type FleetRow } from '../../src/readout';
import {
  all,
  attributes,
  changesBy,
  createPage,
  createView,
  fire,
  layOut,
  one,
  shownText,
} from './pageInNode';

const ROW: FleetRow = {
  shipId: 'a',
  name: 'Kestrel',
  own: false,
  status: 'landed',
  provenance: 'confirmed',
  withdrawn: '',
  height: 0,
};

function fleetOf(
  rows: readonly Partial<FleetRow>[],
  counts: Partial<FleetReadout['counts']> = {},
): FleetReadout {
  const empty = createFleetReadout();
  const filled = rows.map((row) => ({ ...ROW, ...row }));
  return { ...empty, rows: filled, count: rows.length, counts: { ...empty.counts, ...counts } };
}

/** A fleet HUD whose list is `height` px tall. */
function createFleet(height: number, given = createView()) {
  const { document, root } = createPage(given.view);
  const hud = createFleetHud(document, root);
  const scroller = one(root, 'td-scroller');
  layOut(scroller, { clientHeight: height });
  given.resized();
  const places = () => all(root, 'td-row').map((row) => Number(row.getAttribute('aria-posinset')));
  const scrollTo = (top: number) => {
    scroller.scrollTop = top;
    fire(scroller, 'scroll');
  };
  return { ...hud, root, places, scrollTo, resized: given.resized, observed: given.observed, scroller };
}

describe('the fleet', () => {
  it('prints each ship with its status, height and provenance, its own marked', () => {
    const { root, paint } = createFleet(280);
    paint(
      fleetOf([
        { status: 'tipped', name: '<b>Aurora</b>', height: 0 },
        { status: 'contact', provenance: 'predicted', own: true, height: 3.2 },
        { status: 'flight', provenance: 'stale', height: NaN },
        { status: 'flight', provenance: 'off', height: 1200 },
        { status: 'contact', provenance: 'predicted', withdrawn: 'landed' },
      ]),
    );
    expect(all(root, 'td-row').map(shownText)).toEqual([
      '✖ TIPPED <b>Aurora</b> 0.0 m CONF',
      '▲ CONTACT Kestrel 3.2 m PRED',
      '◇ FLIGHT Kestrel -- STALE',
      '◇ FLIGHT Kestrel 1\u202f200 m PRED OFF',
      '▲ CONTACT Kestrel 0.0 m WITHDRAWN',
    ]);
    const marks = (name: string) => all(root, 'td-row').map((row) => row.getAttribute(name));
    expect(marks('data-own')).toEqual(['false', 'true', 'false', 'false', 'false']);
    expect(marks('data-colour')).toEqual(['red', 'yellow', 'neutral', 'neutral', 'yellow']);
    expect(marks('data-provenance')).toEqual(['confirmed', 'predicted', 'stale', 'off', 'predicted']);
    expect(marks('aria-setsize')).toEqual(['5', '5', '5', '5', '5']);
  });

  it('counts in its header the statuses that some ship has', () => {
    const { root, paint } = createFleet(280);
    const header = () => shownText(one(root, 'td-fleet-header'));
    expect(header()).toBe('Fleet');
    paint(fleetOf([ROW], { tipped: 2, flight: 1, landed: 3 }));
    expect(header()).toBe('Fleet 2 tipped 1 in flight 3 landed');
    const colours = all(root, 'td-count').map((count) => count.getAttribute('data-colour'));
    expect(colours).toEqual(['red', 'yellow', 'red', 'neutral', 'cyan', 'quiet']);
    paint(fleetOf([ROW], { contact: 1, landed: 1 }));
    expect(header()).toBe('Fleet 1 in contact 1 landed');
    expect(changesBy(() => paint(fleetOf([ROW], { contact: 1, landed: 1 })))).toBe(0);
  });

  it('is a region that Tab reaches, to scroll it', () => {
    const { scroller } = createFleet(280);
    expect(attributes(scroller, 'role', 'aria-label', 'tabindex')).toEqual(['region', 'Ships', '0']);
  });

  // Rows are 1.75 rem, 28 px at 16 px; one row more than fit, since the first is cut.
  it('has rows only for what is in sight, at most 30, at their places', () => {
    const { root, paint, places, scrollTo, resized, scroller } = createFleet(280);
    const thousand = fleetOf(Array.from({ length: 1000 }, (_, i) => ({ name: `ship ${String(i)}` })));
    paint(thousand);
    expect(one(root, 'td-rows').style.height).toBe('1750rem');
    expect(places()).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
    const transforms = all(root, 'td-row').map(({ style }) => style.transform);
    expect(transforms.slice(0, 3)).toEqual([0, 1.75, 3.5].map((y) => `translateY(${String(y)}rem)`));
    scrollTo(27);
    expect(places()[0]).toBe(1);
    scrollTo(28);
    expect([places()[0], places().at(-1)]).toEqual([2, 12]);
    expect(shownText(all(root, 'td-row')[0]!)).toContain('ship 1 ');
    scrollTo(27_720);
    expect([places()[0], places().at(-1)]).toEqual([990, 1000]);
    scrollTo(-40);
    expect(places()[0]).toBe(1);
    layOut(scroller, { clientHeight: 281 });
    resized();
    expect(places()).toHaveLength(12);
    layOut(scroller, { clientHeight: 4000 });
    resized();
    expect(places()).toHaveLength(30);
    paint(fleetOf([ROW, ROW]));
    expect([places(), one(root, 'td-rows').style.height]).toEqual([[1, 2], '3.5rem']);
    paint(fleetOf([]));
    expect(places()).toEqual([]);
  });

  it.each([
    ['32px', 6],
    ['', 11],
    ['16px', 11],
  ])('has rows as tall as the text: with a root font of "%s", %d rows in 280 px', (fontSize, rows) => {
    const { paint, places } = createFleet(280, createView({ fontSize }));
    paint(fleetOf(Array.from({ length: 50 }, () => ROW)));
    expect(places()).toHaveLength(rows);
  });

  it('shows a row before its height is known, and stops watching at its end', () => {
    const { document, root } = createPage(createView().view);
    const hud = createFleetHud(document, root);
    hud.paint(fleetOf([ROW, ROW, ROW]));
    expect(all(root, 'td-row')).toHaveLength(1);
    const { dispose, observed, root: other } = createFleet(280);
    expect(observed()).toBe(1);
    dispose();
    expect([observed(), all(other, 'td-hud')]).toEqual([0, []]);
  });

  it('is painted in a document without a window, too', () => {
    const { document, root } = createPage();
    const hud = createFleetHud(document, root);
    hud.paint(fleetOf([ROW]));
    const scroller = one(root, 'td-scroller');
    layOut(scroller, { clientHeight: 280 });
    fire(scroller, 'scroll');
    hud.paint(fleetOf(Array.from({ length: 50 }, () => ROW)));
    expect(all(root, 'td-row')).toHaveLength(11);
    hud.dispose();
    expect(all(root, 'td-hud')).toEqual([]);
  });
});

const HUDS = [
  ['Landing', createCockpitLandingHud],
  ['Fleet', createFleetHud],
  ['Flight', createFlightHud],
] as const;

describe.each(HUDS)('the HUD %s', (label, create) => {
  const shownIn = (given = createView(), options: HudAppearance = {}) => {
    const { document, root } = createPage(given.view);
    const { dispose } = create(document, root, options);
    return { section: one(root, 'td-hud'), root, dispose };
  };
  const look = (section: HTMLElement) => attributes(section, 'data-theme', 'data-layout');

  it('is a section with its name and a panel, dark unless asked', () => {
    const { section } = shownIn();
    expect([section.localName, section.className]).toEqual(['section', `td-hud td-${label.toLowerCase()}`]);
    expect(attributes(section, 'aria-label')).toEqual([label]);
    expect([...section.children].map(({ className }) => className)).toEqual(['td-panel']);
    expect(look(section)).toEqual(['dark', 'full']);
    expect(look(shownIn(createView(), { theme: 'light' }).section)).toEqual(['light', 'full']);
  });

  it('is compact in a window of at most 520 px, unless its layout is given', () => {
    const given = createView({ matches: true });
    const { section, dispose } = shownIn(given);
    expect(given.queries).toEqual(['(max-width: 32.5em)']);
    expect(look(section)).toEqual(['dark', 'compact']);
    given.media.matches = false;
    given.media.listeners.forEach((lay) => lay());
    expect(look(section)).toEqual(['dark', 'full']);
    dispose();
    expect(given.media.listeners.size).toBe(0);
    expect(look(shownIn(createView({ matches: true }), { layout: 'full' }).section)).toEqual([
      'dark',
      'full',
    ]);
    expect(look(shownIn(createView(), { layout: 'compact' }).section)).toEqual(['dark', 'compact']);
  });

  it('leaves the page at its end', () => {
    const given = createView();
    const { root, dispose } = shownIn(given);
    dispose();
    expect([all(root, 'td-hud'), given.observed()]).toEqual([[], 0]);
  });
});

it('the landing HUD’s parts can be scrolled by keyboard where they are too short, and only there', () => {
  const given = createView();
  const { document, root } = createPage(given.view);
  createCockpitLandingHud(document, root);
  const parts = one(root, 'td-parts');
  const stop = () => attributes(parts, 'tabindex', 'role', 'aria-label');
  // The parts and each of them: what grows inside is seen too.
  expect(given.observed()).toBe(1 + parts.children.length);
  expect(stop()).toEqual([null, null, null]);
  layOut(parts, { scrollHeight: 200, clientHeight: 200 });
  given.resized();
  expect(stop()).toEqual([null, null, null]);
  layOut(parts, { scrollHeight: 201 });
  given.resized();
  expect(stop()).toEqual(['0', 'group', 'Landing details']);
  expect(changesBy(given.resized)).toBe(0);
  layOut(parts, { scrollHeight: 200 });
  given.resized();
  expect(stop()).toEqual([null, null, null]);
});
