/** Exported values of the source that no file imports. */
import { dirname, join, normalize } from 'node:path/posix';
import { parseSync } from 'vite';
import type { SourceFile } from '../source';

/** Names that a file exports: its own, or another file's by path and name there ('*': all). */
interface Exports {
  readonly own: ReadonlySet<string>;
  readonly passedOn: ReadonlyMap<string, { readonly path: string; readonly name: string }>;
  readonly whole: readonly string[];
}

interface Module {
  readonly exports: Exports;
  /** Names that a file imports, by the other file's path and the name there. */
  readonly imports: readonly { readonly path: string; readonly name: string }[];
}

type Resolve = (from: string, request: string) => string | null;

/** Finds the file that a relative import means among those known. */
function resolverOf(paths: ReadonlySet<string>): Resolve {
  return (from, request) => {
    if (!request.startsWith('.')) return null;
    const target = normalize(join(dirname(from), request));
    const tries = [target, `${target}.ts`, `${target}/index.ts`, target.replace(/\.js$/, '.ts')];
    return tries.find((path) => paths.has(path)) ?? null;
  };
}

function moduleOf(file: SourceFile, resolve: Resolve): Module {
  const { module, errors } = parseSync(file.path, file.text);
  if (errors[0]) throw new Error(`${file.path}: ${errors[0].message}`);
  const imports: { path: string; name: string }[] = [];
  const own = new Set<string>();
  const passedOn = new Map<string, { path: string; name: string }>();
  const whole: string[] = [];
  for (const { moduleRequest, entries } of module.staticImports) {
    const path = resolve(file.path, moduleRequest.value);
    if (path === null) continue;
    for (const { importName } of entries) imports.push({ path, name: importName.name ?? importName.kind });
  }
  // A program that is loaded by name or address counts as used completely.
  for (const [, request] of file.text.matchAll(/(?:import\(\s*|new URL\(\s*|src=)['"](\.[^'"]+)['"]/g)) {
    const path = resolve(file.path, request!);
    if (path !== null) imports.push({ path, name: 'NamespaceObject' });
  }
  for (const { entries } of module.staticExports)
    for (const { moduleRequest, exportName, importName, isType } of entries) {
      // A type may exist to name a function's result.
      if (isType) continue;
      const path = moduleRequest === null ? null : resolve(file.path, moduleRequest.value);
      if (moduleRequest === null) own.add(exportName.name ?? 'default');
      else if (path !== null && exportName.name === null) whole.push(path);
      else if (path !== null) passedOn.set(exportName.name!, { path, name: importName.name! });
    }
  return { exports: { own, passedOn, whole }, imports };
}

/**
 * "path: name" of what a file under src exports and no other file imports.
 * @param doors files whose exports are for users outside of this repository
 */
export function unusedExports(files: readonly SourceFile[], doors: readonly string[]): string[] {
  const resolve = resolverOf(new Set(files.map(({ path }) => path)));
  const modules = new Map(files.map((file) => [file.path, moduleOf(file, resolve)]));
  const used = new Set<string>();
  const use = (path: string, name: string): void => {
    const key = `${path}: ${name}`;
    const { own, passedOn, whole } = modules.get(path)!.exports;
    if (used.has(key)) return;
    used.add(key);
    const source = passedOn.get(name);
    if (source !== undefined) use(source.path, source.name);
    else if (name === 'NamespaceObject')
      for (const each of [...own, ...passedOn.keys(), ...whole.map(() => name)]) use(path, each);
    if (!own.has(name) && source === undefined) for (const each of whole) use(each, name);
  };
  for (const { imports } of modules.values()) for (const { path, name } of imports) use(path, name);
  for (const door of doors) use(door, 'NamespaceObject');
  return [...modules].flatMap(([path, { exports }]) =>
    path.startsWith('src/')
      ? [...exports.own, ...exports.passedOn.keys()]
          .map((name) => `${path}: ${name}`)
          .filter((key) => !used.has(key))
      : [],
  );
}
