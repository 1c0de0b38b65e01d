import { REFERENCES, timerInC } from './cBaseline';
import { heightmapFigures } from './heightmap';
import { joltBody } from './jolt';
import {
  type Figure,
  figure,
  heapGrowth,
  ratioInTurn,
  timed,
  timedInTurn,
  type Timer,
  timerOf,
} from './measure';
import { replayFigures } from './page/replay';
import { workerFigures } from './worker';
import { flying, landed, sliding, slidingOverHills, type Subject, tipped } from './subjects';

/** `npm run bench`: cost of the law. A table, or with --json one line of JSON per figure. */

/** Substeps per round. */
const TIMES = 100_000;
const FLEET = 1000;

function perSubstep(name: string, subject: Subject): Figure {
  return timed(name, TIMES, 1, (times) => subject.step(times));
}

/** The substep in contact beside the two in C. */
function contactFigures(): Figure[] {
  const inC = REFERENCES.map((reference) => timerInC(sliding(), reference, TIMES));
  const [contact, ...references] = timedInTurn([
    timerOfSubstep(sliding()),
    ...inC.filter((timer) => timer !== null),
  ]);
  return [
    figure('contact-substep', 'ns', contact!),
    ...references.flatMap((reference, i) => [
      figure(`contact-c-${REFERENCES[i]!}`, 'ns', reference),
      ratioInTurn(`contact-to-${REFERENCES[i]!}`, contact!, reference),
    ]),
  ];
}

/** The substep in contact over hills, by either surface normal. */
function hillsFigures(): Figure[] {
  const [radial, terrain] = timedInTurn([
    timerOfSubstep(slidingOverHills('radial')),
    timerOfSubstep(slidingOverHills('terrain')),
  ]);
  return [
    figure('contact-hills-radial', 'ns', radial!),
    figure('contact-hills-terrain', 'ns', terrain!),
    ratioInTurn('contact-hills-terrain-to-radial', terrain!, radial!),
  ];
}

const timerOfSubstep = (subject: Subject): Timer => timerOf(TIMES, (times) => subject.step(times));

/** Adopts the server's row, and replays 100 substeps from it. */
function adoptAndReplay(): Figure {
  const subject = sliding();
  const server = subject.ships.slice();
  return timed('replay-100', TIMES / 100, 1, (times) => {
    for (let i = 0; i < times; i++) {
      subject.ships.set(server);
      subject.step(100);
    }
  });
}

/** One second of game time of 1,000 ships in contact. */
function fleetSecond(): Figure {
  const subject = sliding(FLEET);
  return timed('fleet-1000', 1, 1, (times) => {
    for (let i = 0; i < times; i++) subject.step(100);
  });
}

function heapPerSubstep(): Figure {
  const subject = sliding();
  return heapGrowth('heap-per-substep', 1_000_000, (times) => subject.step(times));
}

const asJson = process.argv.includes('--json');

function print(figure: Figure): void {
  if (asJson) console.log(JSON.stringify(figure));
  else {
    const { name, unit, median, min, max } = figure;
    console.log(
      `${name.padEnd(32)} ${String(median).padStart(14)} ${unit.padEnd(6)} (${String(min)} … ${String(max)})`,
    );
  }
}

if (!asJson) console.log(`${''.padEnd(32)} ${'median'.padStart(14)}        (min … max)`);
contactFigures().forEach(print);
hillsFigures().forEach(print);
print(perSubstep('flying-substep', flying()));
print(perSubstep('tipped-substep', tipped()));
print(perSubstep('landed-substep', landed()));
print(adoptAndReplay());
print(fleetSecond());
print(heapPerSubstep());
for (const figure of heightmapFigures()) print(figure);
for (const figure of workerFigures()) print(figure);
for (const figure of await replayFigures()) print(figure);
const jolt = await joltBody();
if (jolt) print(jolt);
