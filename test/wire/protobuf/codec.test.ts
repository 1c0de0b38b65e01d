import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';
import { encodeServerMessage } from '../../../src/wire';
import { HELLO } from '../messages';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const GENERATED = join(ROOT, 'src/wire/generated');

it('is byte for byte what `npm run proto` generates', () => {
  const folder = mkdtempSync(join(tmpdir(), 'codec-'));
  try {
    const run = spawnSync(process.execPath, [join(ROOT, '.ci/proto.mjs'), folder], { encoding: 'utf8' });
    expect(run.status, run.stderr).toBe(0);
    expect(readdirSync(folder).sort()).toEqual(['codec.d.ts', 'codec.js']);
    expect(readdirSync(GENERATED).sort()).toEqual(['codec.d.ts', 'codec.js']);
    for (const file of readdirSync(folder)) {
      const isCurrent = readFileSync(join(folder, file)).equals(readFileSync(join(GENERATED, file)));
      expect(isCurrent, `${file}: run \`npm run proto\` and commit it`).toBe(true);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

/** Decodes a message and prints a name from it, then whether eval was allowed. */
const READS_WITHOUT_EVAL = `
  const { galaxy } = await import(process.argv[1]);
  const message = galaxy.stream.ServerMessage.decode(Buffer.from(process.argv[2], 'base64'));
  const bytes = galaxy.stream.ServerMessage.encode(message).finish();
  let evaluated = 'eval works';
  try { new Function('return 1')(); } catch (error) { evaluated = error.name; }
  console.log(message.hello.ship_classes[0].name, Buffer.from(bytes).toString('base64') === process.argv[2], evaluated);
`;

it('works where eval is forbidden', () => {
  const message = Buffer.from(encodeServerMessage(HELLO)).toString('base64');
  const url = new URL('../../../src/wire/generated/codec.js', import.meta.url).href;
  const node = ['--disallow-code-generation-from-strings', '--input-type=module', '-e', READS_WITHOUT_EVAL];
  const run = spawnSync(process.execPath, [...node, url, message], { encoding: 'utf8', cwd: ROOT });
  expect(run.stdout.trim(), run.stderr).toBe('fast_frigate true EvalError');
});
