// Marks a module's top-level calls as free of side effects, so that a bundler drops them if unused:
// `const UP = vec3(0, 1, 0)` stays in every bundle otherwise. True of src, where modules only define things.
import { parseAst } from 'vite';

const MARK = '/* @__PURE__ */ ';
const FUNCTIONS = new Set([
  'FunctionDeclaration',
  'FunctionExpression',
  'ArrowFunctionExpression',
  'ClassBody',
]);
const COMPOSED = new Set(['ObjectExpression', 'ArrayExpression', 'CallExpression', 'NewExpression']);

/** Calls `visit` with each node below `node` that is evaluated when the module loads. */
function walk(node, visit) {
  if (node === null || typeof node !== 'object' || FUNCTIONS.has(node.type)) return;
  if (typeof node.type === 'string') visit(node);
  for (const value of Array.isArray(node) ? node : Object.values(node)) walk(value, visit);
}

function initialisers(program) {
  return program.body
    .map((statement) => (statement.type === 'ExportNamedDeclaration' ? statement.declaration : statement))
    .filter((statement) => statement?.type === 'VariableDeclaration')
    .flatMap(({ declarations }) => declarations.map(({ init }) => init))
    .filter((init) => init !== null);
}

/** [offset, text] to insert for one initialiser. */
function insertions(init) {
  const calls = [];
  let mayRun = false;
  walk(init, ({ type, start }) => {
    if (type === 'CallExpression' || type === 'NewExpression') calls.push(start);
    mayRun ||= type === 'MemberExpression' || type === 'SpreadElement';
  });
  // For a bundler, a member access or a spread may run code, and only a whole call can be marked. Numbers stay as they are, to be inlined.
  if (mayRun && COMPOSED.has(init.type)) {
    return [
      [init.start, `${MARK}(() => (`],
      [init.end, '))()'],
    ];
  }
  return [...new Set(calls)].map((at) => [at, MARK]);
}

/** The code, with top-level initialisers that may be dropped if unused. */
export function markPure(code) {
  const all = initialisers(parseAst(code)).flatMap(insertions);
  return all
    .sort(([a], [b]) => b - a)
    .reduce((text, [at, mark]) => text.slice(0, at) + mark + text.slice(at), code);
}

/** The vite plugin, for modules of the folder `src` alone. */
export const pure = (src) => ({
  name: 'mark-pure',
  enforce: 'post',
  transform(code, id) {
    // No line moves, so the source map stays valid to the line.
    return id.startsWith(src) && id.endsWith('.ts') ? { code: markPure(code), map: null } : null;
  },
});
