// Type-checks programs that use every export, with old and new TypeScript and every module system, libraries included.
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { tool } from './tools.mjs';

const VERSIONS = ['5.4', '5.6', '5.9', '6.0'];
const MODULES = [
  ['esnext', 'bundler'],
  ['node16', 'node16'],
  ['nodenext', 'nodenext'],
];

/** Names that a declaration file exports, values and types apart. */
function exportsOf(types) {
  const list = types.slice(types.lastIndexOf('export {') + 8, types.lastIndexOf('}'));
  const values = [...types.matchAll(/^declare (?:const|function|class) (\w+)/gm)].map((match) => match[1]);
  const names = list.split(',').map((one) =>
    one
      .trim()
      .split(' as ')
      .at(-1)
      .replace(/^type /, ''),
  );
  return { names: names.filter((name) => name !== ''), values: new Set(values) };
}

/** A program that names every export of every door; an export whose type got lost is `any`, and `used` refuses it. */
function program(folder, doors, extension) {
  const lines = doors.map((door, i) => {
    const types = readFileSync(join(folder, `node_modules/galaxy-touchdown/${door}.${extension}`), 'utf8');
    const { names, values } = exportsOf(types);
    if (names.length === 0) throw new Error(`${door} exports nothing`);
    const from = door === 'index' ? 'galaxy-touchdown' : `galaxy-touchdown/${door}`;
    const uses = names.map((name) =>
      values.has(name) ? `used(d${i}.${name}, true);` : `typed<d${i}.${name}>(true);`,
    );
    return [`import * as d${i} from '${from}';`, ...uses].join('\n');
  });
  return `import 'galaxy-touchdown/hud.css';
declare function used<T>(value: T, isTyped: 0 extends 1 & T ? never : true): void;
declare function typed<T>(isTyped: 0 extends 1 & T ? never : true): void;
${lines.join('\n')}
const predictor: d0.Predictor = d0.createPredictor({ ownShipId: 'a' });
const view: d0.WorldView = predictor.view(0);
const position: Float64Array | undefined = view.own?.meshPosition;
void position;
// @ts-expect-error an option that does not exist
d0.createPredictor({ ownShipID: 'a' });
`;
}

function faultsOf(ts, file, [module, moduleResolution]) {
  const { ModuleKind, ModuleResolutionKind, ScriptTarget } = ts;
  const kind = (table, name) => table[Object.keys(table).find((key) => key.toLowerCase() === name)];
  const host = ts.createProgram([file], {
    target: ScriptTarget.ES2022,
    module: kind(ModuleKind, module),
    moduleResolution: kind(ModuleResolutionKind, moduleResolution),
    lib: ['lib.es2022.d.ts', 'lib.dom.d.ts'],
    types: [],
    ...{ strict: true, exactOptionalPropertyTypes: true, skipLibCheck: false, noEmit: true },
    // On by default from TypeScript 6 on.
    ...(ts.versionMajorMinor >= '5.6' ? { noUncheckedSideEffectImports: true } : {}),
  });
  return ts.getPreEmitDiagnostics(host).map((one) => {
    const place = one.file
      ? `${one.file.fileName}:${one.file.getLineAndCharacterOfPosition(one.start).line + 1} `
      : '';
    return `${place}${ts.flattenDiagnosticMessageText(one.messageText, ' ')}`;
  });
}

/** Throws with the first faults of the first combination that has any. */
export function checkTypes(folder) {
  const files = readdirSync(join(folder, 'node_modules/galaxy-touchdown'));
  const isDoor = (name) => files.includes(`${name}.js`);
  const doors = files
    .filter((file) => file.endsWith('.d.ts'))
    .map((file) => file.slice(0, -5))
    .filter(isDoor);
  // The core first: the program's own lines are about it.
  doors.sort((a, b) => Number(b === 'index') - Number(a === 'index'));
  writeFileSync(join(folder, 'program.ts'), program(folder, doors, 'd.ts'));
  writeFileSync(join(folder, 'program.cts'), program(folder, doors, 'd.cts'));
  const require = createRequire(import.meta.url);
  for (const version of VERSIONS) {
    const ts = require(tool(`typescript-${version}/lib/typescript.js`));
    for (const modules of MODULES) {
      for (const file of ['program.ts', 'program.cts']) {
        const faults = faultsOf(ts, join(folder, file), modules);
        if (faults.length === 0) continue;
        throw new Error(`TypeScript ${version}, ${modules[1]}, ${file}:\n${faults.slice(0, 5).join('\n')}`);
      }
    }
  }
  return `TypeScript ${VERSIONS.join(', ')} × ${MODULES.map(([, name]) => name).join(', ')} × ESM and CommonJS`;
}
