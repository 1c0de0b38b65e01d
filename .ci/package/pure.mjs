// Marks what a module computes while it loads as free of side effects, so that a bundler drops what its user does not use:
// `const UP = vec3(0, 1, 0)` stays in every bundle otherwise. True of src, where modules only define things.
import { parseAst } from 'vite';

const MARK = '/* @__PURE__ */ ';
const FUNCTIONS = new Set(['FunctionDeclaration', 'FunctionExpression', 'ArrowFunctionExpression', 'ClassBody']);

/** Offsets of the calls and constructions below `node` that run when the module loads. */
function callsAt(node, found) {
  if (node === null || typeof node !== 'object' || FUNCTIONS.has(node.type)) return;
  if (Array.isArray(node)) {
    for (const one of node) callsAt(one, found);
    return;
  }
  if (node.type === 'CallExpression' || node.type === 'NewExpression') found.push(node.start);
  for (const [key, value] of Object.entries(node)) if (key !== 'type') callsAt(value, found);
}

function initialisers(program) {
  return program.body
    .map((statement) => (statement.type === 'ExportNamedDeclaration' ? statement.declaration : statement))
    .filter((statement) => statement?.type === 'VariableDeclaration')
    .flatMap(({ declarations }) => declarations.map(({ init }) => init));
}

/** Code with the mark before each call in a top-level initialiser. */
export function markPure(code) {
  const found = [];
  callsAt(initialisers(parseAst(code)), found);
  let marked = code;
  for (const at of [...new Set(found)].sort((a, b) => b - a)) marked = marked.slice(0, at) + MARK + marked.slice(at);
  return marked;
}

/** The vite plugin, for modules of the folder `src` alone. */
export const pure = (src) => ({
  name: 'mark-pure',
  enforce: 'post',
  transform(code, id) {
    // No line moves: the source map made so far stays good to the line.
    return id.startsWith(src) && /\.ts$/.test(id) ? { code: markPure(code), map: null } : null;
  },
});
