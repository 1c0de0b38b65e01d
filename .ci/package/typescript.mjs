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

/** The exports of a declaration file: values by name, types with an argument if they need one. */
function exportsOf(code) {
  const lists = [...code.matchAll(/^export (type )?\{([^}]*)\};/gm)];
  const names = (isType) =>
    lists
      .filter(([, type]) => Boolean(type) === isType)
      .flatMap(([, , list]) => list.split(','))
      .map((one) => one.trim().split(' as ').at(-1));
  const isGeneric = (name) => new RegExp(`(type|interface) ${name}<`).test(code);
  const types = names(true).map((name) => (isGeneric(name) ? [name, '<unknown>'] : [name, '']));
  return { values: names(false), types };
}

/** A program that names every export of every entry; an export that has lost its type is `any`, which `used` refuses. */
function program(folder, doors, extension) {
  const lines = doors.map((door, i) => {
    const code = readFileSync(join(folder, `node_modules/galaxy-touchdown/${door}.${extension}`), 'utf8');
    const { values, types } = exportsOf(code);
    if (values.length === 0) throw new Error(`${door} exports nothing`);
    const from = door === 'index' ? 'galaxy-touchdown' : `galaxy-touchdown/${door}`;
    const uses = [
      ...values.map((name) => `used(d${i}.${name}, true);`),
      ...types.map(([name, argument]) => `typed<d${i}.${name}${argument}>(true);`),
    ];
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

/** TypeScript's own libraries are parsed once per version. */
function hostOf(ts, options, kept) {
  const host = ts.createCompilerHost(options);
  const { getSourceFile } = host;
  const isLibrary = (name) => /\/lib\.[\w.]+\.d\.ts$/.test(name);
  host.getSourceFile = (name, ...rest) => {
    if (!isLibrary(name)) return getSourceFile.call(host, name, ...rest);
    if (!kept.has(name)) kept.set(name, getSourceFile.call(host, name, ...rest));
    return kept.get(name);
  };
  return host;
}

function optionsOf(ts, [module, moduleResolution]) {
  const { ModuleKind, ModuleResolutionKind, ScriptTarget } = ts;
  const kind = (table, name) => table[Object.keys(table).find((key) => key.toLowerCase() === name)];
  return {
    target: ScriptTarget.ES2022,
    module: kind(ModuleKind, module),
    moduleResolution: kind(ModuleResolutionKind, moduleResolution),
    lib: ['lib.es2022.d.ts', 'lib.dom.d.ts'],
    types: [],
    strict: true,
    exactOptionalPropertyTypes: true,
    skipLibCheck: false,
    noEmit: true,
    // Default from TypeScript 6 on.
    ...(ts.versionMajorMinor >= '5.6' ? { noUncheckedSideEffectImports: true } : {}),
  };
}

/** The compiler's errors in the programs and in the package's declarations. */
function faultsOf(ts, files, modules, kept) {
  const options = optionsOf(ts, modules);
  const program = ts.createProgram(files, options, hostOf(ts, options, kept));
  const checked = program.getSourceFiles().filter((file) => !program.isSourceFileDefaultLibrary(file));
  const found = [
    ...program.getOptionsDiagnostics(),
    ...program.getGlobalDiagnostics(),
    ...checked.flatMap((file) => [
      ...program.getSyntacticDiagnostics(file),
      ...program.getSemanticDiagnostics(file),
    ]),
  ];
  return found.map((one) => {
    const line = one.file && one.file.getLineAndCharacterOfPosition(one.start).line + 1;
    const place = one.file ? `${one.file.fileName}:${line} ` : '';
    return `${place}${ts.flattenDiagnosticMessageText(one.messageText, ' ')}`;
  });
}

/** Throws with the first faults of the first combination that has any. */
export function checkTypes(folder) {
  const packed = readdirSync(join(folder, 'node_modules/galaxy-touchdown'));
  const isDoor = (name) => packed.includes(`${name}.js`);
  const doors = packed
    .filter((file) => file.endsWith('.d.ts'))
    .map((file) => file.slice(0, -5))
    .filter(isDoor);
  // The core first: the program's additional lines use it.
  doors.sort((a, b) => Number(b === 'index') - Number(a === 'index'));
  writeFileSync(join(folder, 'program.ts'), program(folder, doors, 'd.ts'));
  writeFileSync(join(folder, 'program.cts'), program(folder, doors, 'd.cts'));
  const files = ['program.ts', 'program.cts'].map((name) => join(folder, name));
  const require = createRequire(import.meta.url);
  for (const version of VERSIONS) {
    const ts = require(tool(`typescript-${version}/lib/typescript.js`));
    const kept = new Map();
    for (const modules of MODULES) {
      const faults = faultsOf(ts, files, modules, kept);
      if (faults.length > 0)
        throw new Error(`TypeScript ${version}, ${modules[1]}:\n${faults.slice(0, 5).join('\n')}`);
    }
  }
  return `TypeScript ${VERSIONS.join(', ')} × ${MODULES.map(([, name]) => name).join(', ')} × ESM and CommonJS`;
}
