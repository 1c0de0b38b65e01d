/**
 * Replays recorded flights through both builds of the packed core, the default one and the one for production, and compares what
 * they show, number by number.
 *   node test/run.mjs test/package/production.ts FOLDER    with the package in FOLDER
 */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type * as Core from '../../src';
import { recordFlight, type RecordedFlight } from '../prediction/recordFlight';
import type { RigOptions } from '../prediction/rig';

type Shown = keyof Core.LandingReadout;

const FLIGHTS: readonly (RigOptions & { readonly scenario: string })[] = [
  { scenario: 'right-itself', others: 2 },
  { scenario: 'stands-on-a-slope', others: 1, legacy: true, secretSettings: { contactFrictionKinetic: 0.2 } },
];
/** Views per look: a full comparison of each is slow. */
const EVERY = 7;

/** Everything that a build shows of a flight, as text. `names`: the members of the landing readout that are shown. */
function shown(core: typeof Core, { entries, options }: RecordedFlight, names: readonly Shown[]): string[] {
  const predictor = core.createPredictor(options);
  const landing = core.createLandingReadout();
  const fleet = core.createFleetReadout();
  const lines: string[] = [];
  predictor.onEvent((notice) => lines.push(JSON.stringify(notice)));
  let views = 0;
  core.replayEntries(predictor, entries, (now) => {
    views += 1;
    if (views % EVERY !== 0) return;
    const view = predictor.view(now);
    core.updateLandingReadout(landing, view);
    const readouts = [names.map((name) => landing[name]), core.updateFleetReadout(fleet, view)];
    lines.push(JSON.stringify([view, readouts, predictor.snapshot(now)], named));
  });
  return lines;
}

/** Derived constants have other names in production: of them the values are compared. */
const named = (key: string, value: unknown): unknown => {
  const isLoaded = (key === 'shipClass' || key === 'settings') && typeof value === 'object' && value !== null;
  return isLoaded ? Object.values(value) : value;
};

/** The warning codes that the build for production still contains, in the order of ERRORS.md's table. */
function remainingCodes(codes: readonly string[]): string[] {
  const files = readdirSync(join(folder, 'production'), { recursive: true, encoding: 'utf8' });
  const code = files
    .filter((file) => /^(index|chunks\/.*)\.js$/.test(file))
    .map((file) => readFileSync(join(folder, 'production', file), 'utf8'))
    .join('\n');
  return codes.filter((name) => new RegExp(`["'\`]${name}["'\`]`).test(code));
}

/** Throws where ERRORS.md lists other codes for production than that build contains. */
function checkCodes(): void {
  const page = readFileSync('src/prediction/ERRORS.md', 'utf8');
  const table = page.slice(page.indexOf('| code'), page.indexOf('## HUDs'));
  const codes = [...table.matchAll(/^\| `([a-z-]+)`/gm)].map(([, name]) => name!);
  const paragraph = /codes remain: ([^.]*)\./.exec(page)?.[1];
  if (paragraph === undefined) throw new Error('ERRORS.md has no sentence "codes remain: …"');
  const listed = [...paragraph.matchAll(/`([a-z-]+)`/g)].map(([, name]) => name!);
  const remaining = remainingCodes(codes);
  if (remaining.length === 0 || listed.join() !== remaining.join())
    throw new Error(
      `ERRORS.md lists for production: ${listed.join(', ')}\nthere are: ${remaining.join(', ')}`,
    );
}

/** A frame, a hello and a clock that are refused, and the field and value that each build must name. */
const REFUSED: readonly (readonly [(core: typeof Core) => string, field: string, value: string])[] = [
  [(core) => reasonOf(core.decodeFrameJson({ tick: -3, ships: [] })), 'tick', '-3'],
  [(core) => reasonOf(core.decodeFrameJson({ tick: 1, ships: 7 })), 'ships', '7'],
  [(core) => reasonOf(core.decodeHelloJson({ settings: { contact_crash_speed: -7 } })), 'crash', '-7'],
  [
    (core) => {
      const predictor = core.createLeanPredictor({ features: [core.gameCatalogue, core.checkedRecords] });
      predictor.receive({ kind: 'frame', tick: 1.5, ships: [] }, 0);
      return predictor.view(0).diagnosis.lastRefusal;
    },
    'frame.tick: ',
    '1.5',
  ],
];

const reasonOf = (result: Core.Result<unknown>): string => (result.ok ? '' : result.reason);

/** Throws where a refusal of the build for production does not name what the other one does, or is not shorter. */
function checkTexts(full: typeof Core, short: typeof Core): void {
  for (const [refused, field, value] of REFUSED) {
    const [long, brief] = [refused(full), refused(short)];
    for (const text of [long, brief])
      if (!text.includes(field) || !text.includes(value))
        throw new Error(`expected ${field} and ${value} in “${text}”`);
    if (!(brief.length < long.length)) throw new Error(`“${brief}” is not shorter than “${long}”`);
  }
  const heard: string[] = [];
  const predictor = short.createPredictor({ onWarning: (code, message) => heard.push(code, message) });
  predictor.advance(null, Number.NaN);
  if (heard.join() !== 'now-not-finite,now-not-finite') throw new Error(`warned: ${heard.join(' ')}`);
}

const folder = process.argv[2]!;
checkCodes();
const load = async (file: string): Promise<typeof Core> =>
  (await import(/* @vite-ignore */ pathToFileURL(join(folder, file)).href)) as typeof Core;
const asIs = await load('index.js');
const forProduction = await load('production/index.js');
checkTexts(asIs, forProduction);
const names = (Object.keys(asIs.createLandingReadout()) as Shown[]).filter((name) => name !== 'memory');
let count = 0;
for (const options of FLIGHTS) {
  const flight = recordFlight(options);
  const expected = shown(asIs, flight, names);
  const got = shown(forProduction, flight, names);
  const at = expected.findIndex((line, i) => line !== got[i]);
  if (expected.length < 50 || expected.length !== got.length || at >= 0)
    throw new Error(
      `${options.scenario}: line ${String(at)} of ${expected.length} (${got.length} in production)\n${expected[at] ?? ''}\n${got[at] ?? ''}`,
    );
  if (!expected.some((line) => line.includes('"shownState":"landed"')))
    throw new Error(`${options.scenario}: nothing landed`);
  count += expected.length;
}
console.log(`production shows the same in ${count} views and events`);
