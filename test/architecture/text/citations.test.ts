import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { citationFaults, readDocuments } from './citations';
import { ROOT, filesUnder, topFiles } from '../source';

const FOLDERS = ['src', 'test', 'proto', '.ci', '.github'];
const TEXT = /(?<!\.d)\.(ts|mjs|js|py|md|proto|css|html|c|h|yml)$|\/run$/;

const hasPath = (path: string) => existsSync(join(ROOT, path));

describe('links and citations in documents and comments', () => {
  const documents = [
    ...topFiles(/\.md$/),
    ...['src', 'test', '.ci'].flatMap((name) => filesUnder(name, /\.md$/)),
  ];
  const known = readDocuments(documents, hasPath);

  it('point at existing files and sections', () => {
    const files = [...topFiles(TEXT), ...FOLDERS.flatMap((folder) => filesUnder(folder, TEXT))];
    const own = /^test\/(architecture|mutants)\/.*test\.ts$/;
    expect(known.sections.size).toBeGreaterThan(4);
    expect(
      files.filter(({ path }) => !own.test(path)).flatMap((file) => citationFaults(file, known)),
    ).toEqual([]);
  });

  const example = readDocuments(
    [{ path: 'src/LAW.md', text: '# Law\n\n## What *it* gives\n\n**1. First.** all\n\n**Range.** all\n' }],
    (path) => path === 'src/LAW.md' || path === 'src/a.ts',
  );
  it.each([
    ['README.md', '[a](src/LAW.md#what-it-gives) [b](https://example.org) [c](#top)\n# Top'],
    [
      'src/a.ts',
      '// LAW, "What it gives": so much\n/* LAW.md, step 1 and src/a.ts\n * LAW, what it\n * gives */',
    ],
    ['src/a.ts', '// LAW (Range) and the OTHER, whatever'],
  ])('accepted in %s: %s', (path, text) => {
    const file = { path, text };
    const both = readDocuments([file, { path: 'src/LAW.md', text: '## What it gives' }], () => true);
    expect(citationFaults(file, path.endsWith('.md') ? both : example)).toEqual([]);
  });

  it.each([
    ['README.md', '[a](src/GONE.md)', 'not there'],
    ['README.md', '[a](src/LAW.md#gone)', 'no such heading'],
    ['src/a.ts', '// LAW, What it takes', 'no such section'],
    ['src/a.ts', '// LAW, What it givesaway', 'no such section'],
    ['src/a.ts', '// LAW.md, step 2', 'no such section'],
    ['src/a.ts', '// as src/gone.ts does', 'not there'],
  ])('a fault in %s: %s', (path, text, said) => {
    expect(citationFaults({ path, text }, example)).toEqual([expect.stringContaining(said)]);
  });
});
