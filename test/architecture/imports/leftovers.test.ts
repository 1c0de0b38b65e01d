/** Types, style rules, fields of the protocol and public files that nothing uses. */
import { describe, expect, it } from 'vitest';
import { filesUnder, topFiles, type SourceFile } from '../source';

const CODE = filesUnder('src', /(?<!\.d)\.(ts|js|html)$/);
const STYLES = filesUnder('src', /\.css$/);
const PROTO = filesUnder('proto', /\.proto$/);
const DOCUMENTS = [...topFiles(/\.md$|^vite\.config\.ts$/), ...filesUnder('src', /\.md$/)];

const textOf = (files: readonly SourceFile[]) => files.map(({ text }) => text).join('\n');
const matches = (pattern: RegExp, text: string) => [
  ...new Set([...text.matchAll(pattern)].map(([, name]) => name!)),
];
const withoutComments = (text: string) => text.replace(/\/\*[^]*?\*\//g, '').replace(/\/\/.*/g, '');
const has = (text: string, name: string) => new RegExp(String.raw`(?<![\w-])${name}(?![\w-])`).test(text);

/** Types that are named nowhere but where they are declared. */
function unusedTypes(files: readonly SourceFile[]): string[] {
  const names = new Map<string, number>();
  for (const word of textOf(files).match(/\b[A-Z]\w+\b/g) ?? []) names.set(word, (names.get(word) ?? 0) + 1);
  return files.flatMap(({ path, text }) =>
    matches(/^(?:export )?(?:interface|type) (\w+)/gm, text)
      .filter((name) => names.get(name) === 1)
      .map((name) => `${path}: ${name}`),
  );
}

/** Classes that no code names. A class of which code builds the end counts if code has its beginning: `td-zone-${name}`. */
function unusedClasses(styles: readonly SourceFile[], code: string): string[] {
  const built = matches(/((?:[a-z]+-)+)\$\{/g, code);
  const names = matches(/\.([a-z][\w-]*)(?=[^{}]*\{)/g, withoutComments(textOf(styles)));
  // uPlot gives its own elements these.
  return names.filter(
    (name) => !has(code, name) && !built.some((start) => name.startsWith(start)) && !name.startsWith('u-'),
  );
}

/** Custom properties that are set and never read. */
function unusedProperties(styles: readonly SourceFile[], code: string): string[] {
  const text = withoutComments(textOf(styles));
  return matches(/(--[\w-]+)\s*:/g, text).filter(
    (name) => !new RegExp(String.raw`var\(\s*${name}(?![\w-])`).test(text) && !has(code, name),
  );
}

/** Fields that `wire` does not read or write. */
function unusedFields(proto: readonly SourceFile[], wire: string): string[] {
  const names = matches(/^\s+(?:repeated |optional )?[\w.]+ (\w+) = \d+/gm, withoutComments(textOf(proto)));
  return names.filter((name) => {
    const camel = name.replace(/_(\w)/g, (_, letter: string) => letter.toUpperCase());
    return !has(wire, camel) && !has(wire, name);
  });
}

describe('leftovers', () => {
  const code = textOf(CODE);

  it('of types do not exist, and one would be found', () => {
    expect(CODE.length).toBeGreaterThan(300);
    expect(unusedTypes(CODE)).toEqual([]);
    const dead = { path: 'src/a.ts', text: 'export interface Never {}\nexport type Used = 1;\nlet a: Used;' };
    expect(unusedTypes([dead])).toEqual(['src/a.ts: Never']);
  });

  it('of style rules do not exist, and one would be found', () => {
    expect(STYLES.length).toBeGreaterThan(10);
    expect(unusedClasses(STYLES, code)).toEqual([]);
    expect(unusedProperties(STYLES, code)).toEqual([]);
    const dead = {
      path: 'a.css',
      text: '/* .told */ .row-of-1, .gone { --dead: 1; color: var(--used-not); }',
    };
    const builds = 'element.className = `row-of-${count}`';
    expect(unusedClasses([dead], builds)).toEqual(['gone']);
    expect(unusedProperties([dead], builds)).toEqual(['--dead']);
  });

  it('of the protocol’s fields do not exist, and one would be found', () => {
    const wire = textOf(CODE.filter(({ path }) => path.startsWith('src/wire/')));
    expect(PROTO.length).toBe(3);
    expect(unusedFields(PROTO, wire)).toEqual([]);
    const dead = {
      path: 'a.proto',
      text: 'message A {\n  repeated Body bodies = 1;\n  bool spare_flag = 2;\n}',
    };
    expect(unusedFields([dead], 'bodies')).toEqual(['spare_flag']);
  });

  it('of public files do not exist', () => {
    const users = code + textOf(DOCUMENTS);
    const names = filesUnder('public', /./).map(({ path }) => path.split('/').at(-1)!);
    expect(names.length).toBeGreaterThan(5);
    expect(names.filter((name) => !users.includes(name))).toEqual([]);
  });
});
