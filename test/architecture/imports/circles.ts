/** Files that import each other in a circle: neither can be read without the other. */
import { dirname, join, normalize } from 'node:path/posix';
import { importsOf } from './importTable';
import type { SourceFile } from '../source';

/** Which imports count: with 'values', `import type` does not. */
type Kinds = 'values' | 'all';

function importedBy(file: SourceFile, paths: ReadonlySet<string>, kinds: Kinds): string[] {
  return importsOf(file).flatMap(({ request, isType }) => {
    if (isType && kinds === 'values') return [];
    if (request === null || !request.startsWith('.')) return [];
    const target = normalize(join(dirname(file.path), request));
    const found = [target, `${target}.ts`, `${target}/index.ts`].find((path) => paths.has(path));
    return found === undefined ? [] : [found];
  });
}

/** "a.ts → b.ts → a.ts" for each circle that a walk from file to file closes. */
export function circlesOf(files: readonly SourceFile[], kinds: Kinds): string[] {
  const paths = new Set(files.map(({ path }) => path));
  const imports = new Map(files.map((file) => [file.path, importedBy(file, paths, kinds)]));
  const done = new Set<string>();
  const circles: string[] = [];
  const walk = (path: string, way: readonly string[]): void => {
    const at = way.indexOf(path);
    if (at >= 0) circles.push([...way.slice(at), path].join(' → '));
    if (at >= 0 || done.has(path)) return;
    for (const next of imports.get(path) ?? []) walk(next, [...way, path]);
    done.add(path);
  };
  for (const { path } of files) walk(path, []);
  return circles;
}
