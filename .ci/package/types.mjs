// Writes the declarations of the package: one self-contained file per entry, for both module systems.
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { rollup } from 'rollup';
import { dts } from 'rollup-plugin-dts';

/** Declarations import each other like the sources: without extension, and folders by their index. */
const besideEachOther = {
  name: 'beside-each-other',
  resolveId(id, from) {
    if (!from || !id.startsWith('.')) return null;
    const base = resolve(dirname(from), id.replace(/\.js$/, ''));
    return [`${base}.d.ts`, join(base, 'index.d.ts')].find(existsSync) ?? null;
  },
};

function emit(root, folder, doors) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const options = {
    extends: join(root, 'tsconfig.json'),
    compilerOptions: {
      noEmit: false,
      declaration: true,
      emitDeclarationOnly: true,
      // What is marked @internal is no part of the package, and production shortens its names (code/shortNames.mjs).
      stripInternal: true,
      noCheck: true,
      types: [],
      lib: ['es2023', 'dom'],
      rootDir: join(root, 'src'),
      outDir: join(folder, 'src'),
    },
    include: [],
    files: Object.values(doors).map((source) => join(root, source)),
  };
  const project = join(folder, 'tsconfig.json');
  writeFileSync(project, JSON.stringify(options));
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  const run = spawnSync(process.execPath, [tsc, '-p', project], { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(`the declarations cannot be emitted:\n${run.stdout}`);
  // A declaration beside generated JavaScript is input to the compiler, which does not copy it.
  const codec = 'src/wire/generated/codec.d.ts';
  if (existsSync(join(root, codec))) cpSync(join(root, codec), join(folder, codec));
}

/** Before TypeScript 5.7 typed arrays are not generic; from 5.7 on the plain name means the same here. */
const withoutGenerics = (code) => code.replace(/\b((?:Uint|Int|Float)\d+Array)<ArrayBuffer(?:Like)?>/g, '$1');

/** @param doors door name to source path below `root`; the files are `out`/door.d.ts and .d.cts */
export async function writeTypes(root, doors, out) {
  const folder = join(root, 'node_modules/.cache/touchdown/types');
  emit(root, folder, doors);
  for (const [door, source] of Object.entries(doors)) {
    const input = join(folder, source.replace(/\.ts$/, '.d.ts'));
    const bundle = await rollup({ input, plugins: [besideEachOther, dts()], external: ['three'] });
    const { output } = await bundle.generate({ format: 'es' });
    await bundle.close();
    if (output.length !== 1) throw new Error(`${door}: expected one file of declarations`);
    const types = withoutGenerics(output[0].code);
    for (const extension of ['d.ts', 'd.cts']) writeFileSync(join(out, `${door}.${extension}`), types);
  }
}
