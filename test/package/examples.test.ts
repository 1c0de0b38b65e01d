/** Each exported function has an example, and each example compiles. */
import { dirname, join } from 'node:path';
import ts from 'typescript';
import { describe, expect, it } from 'vitest';

const ROOT = join(import.meta.dirname, '../..');
const DOORS = ['index', 'protobuf', 'hud/index', 'scene/index', 'game/index'].map((door) => `src/${door}.ts`);
const sandboxNamed = (name: string): string => join(ROOT, 'src', `${name}.sandbox.ts`);

/** Names that an example may use undeclared: a frame loop's time, a received message, the page, and a running predictor. */
const GLOBALS = `
declare global {
  const now: number; const text: string; const bytes: Uint8Array; const message: unknown;
  const after: (seconds: number, act: () => void) => () => void;
  const socket: WebSocket; const host: HTMLElement; const canvas: HTMLCanvasElement; const token: string;
}
export {};
`;
const GIVEN = `
declare const predictor: import('./index').Predictor;
declare const scene: import('./scene').SceneView;
declare const entries: import('./index').PredictorEntry[];
`;

interface Example {
  readonly name: string;
  readonly code: string;
}

const config = ts.parseJsonConfigFileContent(
  ts.readConfigFile(join(ROOT, 'tsconfig.json'), (path) => ts.sys.readFile(path)).config,
  ts.sys,
  ROOT,
);
const OPTIONS: ts.CompilerOptions = {
  ...config.options,
  noEmit: true,
  noUnusedLocals: false,
  noUnusedParameters: false,
  verbatimModuleSyntax: false,
  // An example runs on a page: without node's own names.
  types: [],
};

const isOurs = (path: string): boolean => path.startsWith(join(ROOT, 'src'));

/** Of packages and the platform only the types are needed: parsing their comments too takes a second. */
const withoutWords = (
  language: ts.ScriptTarget | ts.CreateSourceFileOptions,
): ts.CreateSourceFileOptions => ({
  ...(typeof language === 'object' ? language : { languageVersion: language }),
  jsDocParsingMode: ts.JSDocParsingMode.ParseNone,
});

/** A program of the doors and of sandboxes, by path; files of `before` are parsed once. */
function programOf(sandboxes: ReadonlyMap<string, string>, before?: ts.Program): ts.Program {
  const host = ts.createCompilerHost(OPTIONS);
  const read = host.getSourceFile.bind(host);
  host.getSourceFile = (path, language) => {
    const sandbox = sandboxes.get(path);
    if (sandbox !== undefined) return ts.createSourceFile(path, sandbox, language, true);
    return before?.getSourceFile(path) ?? read(path, isOurs(path) ? language : withoutWords(language));
  };
  const exists = host.fileExists.bind(host);
  host.fileExists = (path) => sandboxes.has(path) || exists(path);
  const roots = [...DOORS.map((door) => join(ROOT, door)), ...sandboxes.keys()];
  return ts.createProgram(roots, OPTIONS, host, before);
}

const first = programOf(new Map());
const checker = first.getTypeChecker();

const exported = DOORS.flatMap((door) => {
  const module = checker.getSymbolAtLocation(first.getSourceFile(join(ROOT, door))!)!;
  return checker.getExportsOfModule(module).map((symbol) => ({
    door,
    symbol: symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol,
  }));
});
const functions = exported.filter(({ symbol }) => symbol.flags & ts.SymbolFlags.Function);

const examples: Example[] = functions.flatMap(({ symbol }) =>
  symbol
    .getJsDocTags(checker)
    .filter(({ name }) => name === 'example')
    .map(({ text }) => ({
      name: symbol.name,
      code: /```ts\n([^]*?)```/.exec(ts.displayPartsToString(text))?.[1] ?? '',
    })),
);

/** Imports of every exported name that the code has. */
function importsOf(code: string): string {
  const words = new Set(code.match(/\w+/g));
  return DOORS.map((door) => {
    const names = exported.filter((one) => one.door === door && words.has(one.symbol.name));
    const list = [...new Set(names.map(({ symbol }) => symbol.name))].join(', ');
    return list === '' ? '' : `import { ${list} } from './${door.slice(4, -3)}';`;
  }).join('');
}

/** All examples in one module, each in its own block. */
function sandboxOf(all: readonly Example[]): string {
  const blocks = all.map(({ name, code }) => `/* ${name} */ {\n${code}\n}`).join('\n');
  return `${importsOf(blocks)}${GIVEN}${blocks}\n`;
}

const WRONG = { name: 'wrong', code: 'createPredictor({ ownShip: 1 });' };
const SANDBOXES = new Map([
  [sandboxNamed('globals'), GLOBALS],
  [sandboxNamed('examples'), sandboxOf(examples)],
  [sandboxNamed('wrong'), sandboxOf([WRONG])],
]);

/** Of all: to check the types of a program costs more than to check one more file of it. */
const checked = programOf(SANDBOXES, first);

function faultsOf(sandbox: string): string[] {
  const file = checked.getSourceFile(sandboxNamed(sandbox))!;
  const found = [...checked.getSyntacticDiagnostics(file), ...checked.getSemanticDiagnostics(file)];
  return found.map(({ start, messageText }) => {
    const line = file.getLineAndCharacterOfPosition(start ?? 0).line;
    return `${file.text.split('\n')[line]!.trim()}: ${ts.flattenDiagnosticMessageText(messageText, ' ')}`;
  });
}

describe('the package’s examples', () => {
  it('exist for each function', () => {
    expect(functions.length).toBeGreaterThan(30);
    const without = functions.filter(({ symbol }) => !examples.some(({ name }) => name === symbol.name));
    expect(without.map(({ door, symbol }) => `${dirname(door)}: ${symbol.name}`)).toEqual([]);
  });

  it('compile', () => {
    expect(faultsOf('examples')).toEqual([]);
  });

  it('are found to be wrong where they are', () => {
    expect(faultsOf('wrong')).toEqual([expect.stringContaining('ownShip')]);
  });
});

/** The documentation of each quaternion passed in or out states its order. */
describe('quaternions', () => {
  const ATTITUDE = /attitude$|^targetAttitude$/i;

  it('are documented with the order of their components', () => {
    const members = exported
      .filter(({ symbol }) => symbol.flags & ts.SymbolFlags.Interface)
      .flatMap(({ symbol }) =>
        [...(symbol.members?.values() ?? [])]
          .filter((member) => ATTITUDE.test(member.name) && isList(member))
          .map((member) => ({
            name: `${symbol.name}.${member.name}`,
            text: `${words(member)} ${words(symbol)} ${typeWords(member)}`,
          })),
      );
    expect(members.length).toBeGreaterThan(5);
    expect(members.filter(({ text }) => !/x, y, z, w|w, x, y, z/.test(text)).map(({ name }) => name)).toEqual(
      [],
    );
  });

  const isList = (member: ts.Symbol): boolean =>
    /Quat|Float64Array|\[/.test(checker.typeToString(checker.getTypeOfSymbol(member)));

  function words(symbol: ts.Symbol): string {
    return ts.displayPartsToString(symbol.getDocumentationComment(checker));
  }

  /** Of the member's declared type: Quat states it once for all. */
  function typeWords(member: ts.Symbol): string {
    const declared = member.valueDeclaration as ts.PropertySignature | undefined;
    if (declared?.type === undefined || !ts.isTypeReferenceNode(declared.type)) return '';
    const symbol = checker.getSymbolAtLocation(declared.type.typeName);
    if (symbol === undefined) return '';
    return words(symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol);
  }
});
