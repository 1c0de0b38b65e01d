import { readdirSync } from 'node:fs';
import { dirname } from 'node:path/posix';
import { describe, expect, it } from 'vitest';
import { ROOT, filesUnder } from './source';
import type { SourceFile } from './source';

/** Everything at the top: what a reader opens first, and what tools look up by name. */
const TOP = [
  ...['src', 'test', 'proto', 'public', 'README.md', 'ARCHITECTURE.md', 'CONTRIBUTING.md'],
  ...['LICENSE', 'CHANGELOG.md'],
  ...[
    'package.json',
    'package-lock.json',
    'tsconfig.json',
    'vite.config.ts',
    'eslint.config.js',
    'typedoc.json',
  ],
  ...[
    '.ci',
    '.github',
    '.editorconfig',
    '.gitattributes',
    '.gitignore',
    '.prettierignore',
    '.prettierrc.json',
  ],
];

/** Not part of the project: installed and generated files, and those of a developer's machine. */
const NOT_OURS = new Set([
  'node_modules',
  'dist',
  '.git',
  '.vitest-attachments',
  '.DS_Store',
  '.idea',
  '.vscode',
]);

const MAX_LINES = 250;

/** Most sources of a folder without folders. */
const MAX_FILES = 12;

/** "path: lines" of the files that must be split. */
function tooLong(files: readonly SourceFile[]): string[] {
  return files.flatMap(({ path, text }) => {
    const lines = text.trimEnd().split('\n').length;
    return lines > MAX_LINES ? [`${path}: ${lines} lines`] : [];
  });
}

/** "folder: files" of the folders that need rooms. A declaration file counts with its script. */
function crowded(paths: readonly string[]): string[] {
  const files = new Map<string, number>();
  for (const path of paths.filter((one) => !one.endsWith('.d.mts'))) {
    files.set(dirname(path), (files.get(dirname(path)) ?? 0) + 1);
  }
  const hasRooms = (folder: string) => paths.some((path) => dirname(path).startsWith(`${folder}/`));
  return [...files].flatMap(([folder, count]) =>
    count > MAX_FILES && !hasRooms(folder) ? [`${folder}: ${count} files`] : [],
  );
}

describe('the tree', () => {
  it('has exactly the known entries at the top level', () => {
    const found = readdirSync(ROOT).filter((name) => !NOT_OURS.has(name) && !name.endsWith('.log'));
    expect(found.sort()).toEqual(TOP.sort());
  });

  it(`has no source file over ${MAX_LINES} lines`, () => {
    const source = /\.(ts|js|mjs|py|css|html|proto)$/;
    const files = ['src', 'test', 'proto', '.ci'].flatMap((folder) => filesUnder(folder, source));
    expect(files.length).toBeGreaterThan(20);
    expect(tooLong(files)).toEqual([]);
  });

  it(`has no folder of over ${MAX_FILES} sources without folders`, () => {
    const source = /\.(ts|js|mjs|py|css)$/;
    const files = ['src', 'test', '.ci'].flatMap((folder) => filesUnder(folder, source));
    expect(crowded(files.map(({ path }) => path))).toEqual([]);
  });

  it('fails for a folder that is too full, unless it has rooms', () => {
    const full = Array.from({ length: MAX_FILES + 1 }, (_, i) => `src/a/${i}.ts`);
    expect(crowded(full)).toEqual(['src/a: 13 files']);
    expect(crowded(full.slice(1))).toEqual([]);
    expect(crowded([...full, 'src/a/b/1.ts'])).toEqual([]);
  });

  it('fails for a file that is too long', () => {
    const text = 'x\n'.repeat(MAX_LINES);
    expect(tooLong([{ path: 'a.ts', text }])).toEqual([]);
    expect(tooLong([{ path: 'a.ts', text: `${text}x\n` }])).toEqual(['a.ts: 251 lines']);
  });
});
