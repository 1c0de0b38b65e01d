import { readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { ROOT, filesUnder } from './source';
import type { SourceFile } from './source';

/** Everything at the top: what a reader opens first, and what tools ask for by name. */
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

/** Not the project's: what it installs and makes, and what a person's own machine adds. */
const NOT_OURS = new Set([
  'node_modules',
  'dist',
  '.git',
  '.vitest-attachments',
  '.DS_Store',
  '.idea',
  '.vscode',
]);

const MAX_LINES = 300;

/** "path: lines" of the files that ask for a split. */
function tooLong(files: readonly SourceFile[]): string[] {
  return files.flatMap(({ path, text }) => {
    const lines = text.trimEnd().split('\n').length;
    return lines > MAX_LINES ? [`${path}: ${lines} lines`] : [];
  });
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

  it('fails for a file that is too long', () => {
    const text = 'x\n'.repeat(MAX_LINES);
    expect(tooLong([{ path: 'a.ts', text }])).toEqual([]);
    expect(tooLong([{ path: 'a.ts', text: `${text}x\n` }])).toEqual(['a.ts: 301 lines']);
  });
});
