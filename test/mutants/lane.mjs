// A process that runs test files on one change after the other, without a new start of the runner for each.
//   node test/mutants/lane.mjs node|browser    then messages { mutant, tests, bail } answered by { files: [{ test, isPassed, took }] }
import { relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { BaseSequencer, createVitest } from 'vitest/node';
import { bundleRun } from '../bundle.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

/** Runs files in the order in which they are given: the quickest first. */
class AsGiven extends BaseSequencer {
  async sort(files) {
    const paths = files.map(({ moduleId }) => moduleId);
    bundleRun(process.argv[2] === 'node' ? [paths] : paths.map((path) => [path]));
    return files;
  }
}

const vitest = await createVitest('test', {
  root: ROOT,
  project: process.argv[2] === 'node' ? ['node', 'programs'] : [process.argv[2]],
  watch: false,
  maxWorkers: 1,
  bail: process.env.TOUCHDOWN_PROBES ? 0 : 1,
  reporters: [{}],
  sequence: { sequencer: AsGiven },
});
const all = new Map(
  (await vitest.globTestSpecifications()).map((specification) => [
    relative(ROOT, specification.moduleId).replaceAll('\\', '/'),
    specification,
  ]),
);

async function run({ mutant, tests }) {
  process.env.TOUCHDOWN_MUTANT = mutant ? JSON.stringify(mutant) : '';
  for (const { vite } of vitest.projects)
    for (const { moduleGraph } of Object.values(vite.environments)) moduleGraph.invalidateAll();
  const specifications = tests.map((test) => all.get(test));
  const { testModules, unhandledErrors } = await vitest.rerunTestSpecifications(specifications);
  const files = tests.map((test) => {
    const module = testModules.find(({ moduleId }) => moduleId === all.get(test).moduleId);
    const { collectDuration = 0, duration = 0 } = module?.diagnostic() ?? {};
    return { test, isPassed: module?.state() === 'passed', took: collectDuration + duration };
  });
  return { files, isPassed: unhandledErrors.length === 0 && files.every(({ isPassed }) => isPassed) };
}

process.on('message', (work) => {
  run(work).then(
    (done) => process.send(done),
    (error) => process.send({ files: [], isPassed: false, error: String(error) }),
  );
});
process.on('disconnect', () => void vitest.close().finally(() => process.exit()));
process.send('ready');
