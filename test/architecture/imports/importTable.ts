/** The table of permitted imports, and its check over one file. */
import { dirname, join, normalize } from 'node:path/posix';
import { placeOf, visitTree } from '../source';
import type { Node, SourceFile } from '../source';

/** 'values' allows every import, 'types' only `import type`. */
type Allowance = 'values' | 'types';

const ALL = 'all';

/** By folder of src: the folders and packages that it may import. */
export const IMPORT_TABLE: Readonly<Record<string, typeof ALL | Readonly<Record<string, Allowance>>>> = {
  dynamics: {},
  protocol: {},
  wire: { dynamics: 'values', protocol: 'values', protobufjs: 'values' },
  prediction: { dynamics: 'values', protocol: 'values', wire: 'types' },
  readout: { dynamics: 'values', prediction: 'types' },
  hud: { readout: 'values' },
  scene: { dynamics: 'values', prediction: 'types', three: 'values', 'gl-matrix': 'values' },
  authority: { dynamics: 'values', protocol: 'values', wire: 'values' },
  scenarios: { dynamics: 'values', wire: 'values', authority: 'values' },
  game: { dynamics: 'values', wire: 'values' },
  gateway: {
    dynamics: 'values',
    protocol: 'values',
    wire: 'values',
    ws: 'values',
    redis: 'values',
    jose: 'values',
    'node:crypto': 'values',
    'node:http': 'values',
    'node:net': 'types',
    'node:stream': 'types',
    'node:util': 'values',
  },
  playground: ALL,
  example: { 'galaxy-touchdown': 'values', three: 'values' },
  'index.ts': ALL,
  'protobuf.ts': { wire: 'values' },
};

/** An import as written: `request` is null when it is not a plain string. */
interface Import {
  readonly request: string | null;
  readonly isType: boolean;
  readonly start: number;
}

function literal(node: unknown): string | null {
  const value = (node as Node | null | undefined)?.['value'];
  return typeof value === 'string' ? value : null;
}

/** `new URL('./x', import.meta.url)`: how a worker or an asset is named. */
function urlRequest(node: Node): Import[] {
  const callee = node['callee'] as Node;
  const [path, base] = node['arguments'] as Node[];
  if (callee['name'] !== 'URL' || !base || base.type !== 'MemberExpression') return [];
  if ((base['object'] as Node).type !== 'MetaProperty') return [];
  return [{ request: literal(path), isType: false, start: node.start }];
}

function importsAt(node: Node): Import[] {
  const { start } = node;
  switch (node.type) {
    case 'ImportDeclaration':
      return [{ request: literal(node['source']), isType: node['importKind'] === 'type', start }];
    case 'ExportNamedDeclaration':
    case 'ExportAllDeclaration':
      if (!node['source']) return [];
      return [{ request: literal(node['source']), isType: node['exportKind'] === 'type', start }];
    case 'ImportExpression':
      return [{ request: literal(node['source']), isType: false, start }];
    case 'TSImportType':
      return [{ request: literal(node['source'] ?? node['argument']), isType: true, start }];
    case 'TSExternalModuleReference':
      return [{ request: literal(node['expression']), isType: false, start }];
    case 'NewExpression':
      return urlRequest(node);
    default:
      return [];
  }
}

/** Every import of a file, in whichever form. */
export function importsOf(file: SourceFile): readonly Import[] {
  const before = read.get(file.path);
  if (before?.text === file.text) return before.imports;
  const imports: Import[] = [];
  visitTree(file, (node) => imports.push(...importsAt(node)));
  read.set(file.path, { text: file.text, imports });
  return imports;
}

/** By path: several tests need the imports of every file, and parsing them all takes a second. */
const read = new Map<string, { readonly text: string; readonly imports: readonly Import[] }>();

function packageName(request: string): string {
  return request
    .split('/')
    .slice(0, request.startsWith('@') ? 2 : 1)
    .join('/');
}

/** What is wrong with one import of the file at `path`, or null. */
function complaint(path: string, { request, isType }: Import): string | null {
  if (request === null) return 'imports what is not a plain string';
  const folder = path.split('/')[1]!;
  const isLocal = request.startsWith('.');
  const target = isLocal ? normalize(join(dirname(path), request)) : request;
  if (isLocal && !target.startsWith('src/')) return `imports ${request}, outside of src`;
  const [, to = '', ...inside] = target.split('/');
  const name = isLocal ? to : packageName(request);
  if (isLocal && (name === folder || folder === 'index.ts') && inside.length > 0 && name === folder)
    return null;
  if (isLocal && inside.length > 0 && !(inside.length === 1 && inside[0] === 'index')) {
    return `imports ${request}, past the index of ${name}`;
  }
  const row = IMPORT_TABLE[folder];
  if (row === undefined) return `is in ${folder}, a folder that the import table does not know`;
  if (row === ALL) return null;
  const allowance = row[name];
  if (allowance === undefined) return `imports ${name}, which ${folder} may not`;
  return allowance === 'types' && !isType
    ? `imports values of ${name}: ${folder} may import its types alone`
    : null;
}

/** "place imports …" for every import of `file` that the table forbids. */
export function importFaults(file: SourceFile): string[] {
  return importsOf(file).flatMap((one) => {
    const said = complaint(file.path, one);
    return said === null ? [] : [`${placeOf(file, one.start)} ${said}`];
  });
}
