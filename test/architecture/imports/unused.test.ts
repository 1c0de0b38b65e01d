/** Unused files and packages. */
import { describe, expect, it } from 'vitest';
import { dirname, join, normalize } from 'node:path/posix';
import { importsOf } from './importTable';
import { filesUnder, topFiles } from '../source';
import type { SourceFile } from '../source';

const CODE = ['src', 'test', '.ci'].flatMap((folder) => filesUnder(folder, /(?<!\.d)\.m?[tj]s$/));
const CONFIG = topFiles(/^(package|tsconfig|typedoc)\.json$|\.(js|ts)$/);
const PAGES = ['src', 'test'].flatMap((folder) => filesUnder(folder, /\.html$/));
/** Files that name programs which a person or CI starts. */
const STARTS = [...topFiles(/^CONTRIBUTING\.md$/), ...filesUnder('.ci', /^\.ci\/run$/)];

/** Files under `files` that no other file imports or names by its path, tests and doors apart. */
function unreached(files: readonly SourceFile[], others: readonly SourceFile[]): string[] {
  const imported = new Set<string>();
  for (const file of files)
    for (const { request } of importsOf(file)) {
      if (request === null || !request.startsWith('.')) continue;
      const target = normalize(join(dirname(file.path), request));
      for (const path of [target, `${target}.ts`, `${target}/index.ts`])
        if (path !== file.path) imported.add(path);
    }
  const texts = [...files, ...others];
  const isNamed = (path: string): boolean => {
    const name = path.split('/').at(-1)!;
    const named = new RegExp(String.raw`["'\`/]${name.replaceAll('.', '\\.')}\b`);
    // The plain search first: the pattern takes many times as long.
    return texts.some((other) => other.path !== path && other.text.includes(name) && named.test(other.text));
  };
  return files
    .map(({ path }) => path)
    .filter((path) => !imported.has(path) && !/\.test\.ts$/.test(path) && !isNamed(path));
}

/** Packages of package.json that neither code nor configuration names. */
function unusedPackages(manifest: string, texts: readonly string[]): string[] {
  const { dependencies, devDependencies } = JSON.parse(manifest) as Record<string, Record<string, string>>;
  return Object.keys({ ...dependencies, ...devDependencies }).filter((name) => {
    // A package's types are used with the package.
    const used = name.replace(/^@types\//, '');
    const asked = new RegExp(
      String.raw`['"\`/ ]${used.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')}(?:['"\`/ ]|$)`,
      'm',
    );
    return used !== 'node' && !texts.some((text) => text.includes(used) && asked.test(text));
  });
}

describe('unused files and packages', () => {
  it('there is no file that is neither imported nor started by name', () => {
    expect(CODE.length).toBeGreaterThan(300);
    expect(unreached(CODE, [...CONFIG, ...PAGES, ...STARTS])).toEqual([]);
  });

  it('an unreachable file is found', () => {
    // Joined here, so that this file does not contain the name.
    const path = `src/hud/${['for', 'gotten'].join('')}.ts`;
    const dead = { path, text: 'export const a = 1;' };
    expect(unreached([...CODE, dead], [...CONFIG, ...PAGES, ...STARTS])).toEqual([path]);
  });

  const manifest = CONFIG.find(({ path }) => path === 'package.json')!.text;
  const scripts = JSON.stringify((JSON.parse(manifest) as { scripts: unknown }).scripts);
  const texts = [
    scripts,
    ...[...CODE, ...PAGES, ...CONFIG.filter(({ path }) => path !== 'package.json')].map(({ text }) => text),
  ];

  it('there is no package that is neither imported nor run', () => {
    expect(unusedPackages(manifest, texts)).toEqual([]);
  });

  it('an unused package is found', () => {
    // Joined here, so that this file does not contain the name.
    const name = ['never', 'asked'].join('-');
    const withOne = JSON.stringify({
      dependencies: { three: '1', [name]: '1' },
      devDependencies: {},
    });
    expect(unusedPackages(withOne, texts)).toEqual([name]);
  });
});
