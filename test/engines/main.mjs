// npm run engines: the same landings in other JavaScript engines, one line each with version and hash.
// Exit 1 on any difference, or when fewer than three engine families agree.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { bundleScript } from './bundle.mjs';
import { ENGINES, runScript } from './engines.mjs';
import { describeAnswer, verdictOf } from './verdict.mjs';

const OUT = fileURLToPath(new URL('../../node_modules/.cache/touchdown/trajectories', import.meta.url));
const source = readFileSync(new URL('./hash.ts', import.meta.url), 'utf8');
const pinned = /PINNED_HASH = '([0-9a-f]{8})'/.exec(source)?.[1] ?? '';

const script = await bundleScript(OUT);
const answers = [];
for (const { family, find } of ENGINES) {
  const found = find();
  const answer = { family, ...found, ...(found.missing ? {} : runScript(found.command, script)) };
  answers.push(answer);
  const reference = answers.find(({ lines }) => lines)?.lines ?? [];
  console.log(describeAnswer(answer, reference).line);
}
const { summary, complaints } = verdictOf(answers, pinned);
console.log(summary);
for (const complaint of complaints) console.error(complaint);
process.exitCode = complaints.length > 0 ? 1 : 0;
