// Inlines a module's numeric constants: the users' minifiers inline imported constants only, and every constant that
// stays costs a name, a line and a look-up. Indices are added up: `rows[at + 3 + 1]` becomes `rows[at + 4]`. Infinities become
// divisions, which are shorter. The results are the same, bit for bit.
import { parseAst } from 'vite';

const isNumber = (node) =>
  (node?.type === 'Literal' && typeof node.value === 'number') ||
  (node?.type === 'UnaryExpression' && node.operator === '-' && isNumber(node.argument));

/** Declarations `const NAME = <number>` of a module's top level, by name. */
function numbersOf(program) {
  const declarations = program.body
    .map((statement) => (statement.type === 'ExportNamedDeclaration' ? statement.declaration : statement))
    .filter((statement) => statement?.type === 'VariableDeclaration' && statement.kind === 'const')
    .flatMap((statement) => statement.declarations)
    .filter(({ id, init }) => /^[A-Z][A-Z0-9_]*$/.test(id.name) && isNumber(init));
  return new Map(declarations.map(({ id, init }) => [id.name, { id, init }]));
}

/** Calls `visit` with each identifier that may be a use of a variable, and its parent. */
function eachUse(node, parent, visit) {
  if (node === null || typeof node !== 'object') return;
  if (node.type === 'Identifier' && !isName(node, parent)) visit(node, parent);
  const above = typeof node.type === 'string' ? node : parent;
  for (const value of Array.isArray(node) ? node : Object.values(node)) eachUse(value, above, visit);
}

const isName = (node, parent) =>
  (parent.type === 'MemberExpression' && parent.property === node && !parent.computed) ||
  (parent.type === 'Property' && parent.key === node && !parent.computed) ||
  /Specifier$/.test(parent.type);

const INFINITIES = { POSITIVE_INFINITY: '(1 / 0)', NEGATIVE_INFINITY: '(-1 / 0)' };

/** `[node, text]` for each infinity of `Number`. */
function infinitiesIn(node) {
  if (node === null || typeof node !== 'object') return [];
  const { type, object, property } = node;
  const text = type === 'MemberExpression' && object.name === 'Number' && INFINITIES[property.name];
  if (text) return [[node, text]];
  return (Array.isArray(node) ? node : Object.values(node)).flatMap(infinitiesIn);
}

/** The code with its upper-case top-level numbers and its infinities inlined; no line moves. */
export function inlineNumbers(code) {
  const program = parseAst(code);
  const numbers = numbersOf(program);
  const uses = infinitiesIn(program);
  eachUse(program, program, (node, parent) => {
    const number = numbers.get(node.name);
    if (number === undefined || node === number.id) return;
    const value = code.slice(number.init.start, number.init.end);
    const text = number.init.type === 'Literal' ? value : `(${value})`;
    const isShorthand = parent.type === 'Property' && parent.shorthand;
    uses.push([node, isShorthand ? `${node.name}: ${text}` : text]);
  });
  return withTexts(code, uses);
}

/** The code with `[node, text]` in place of each node. */
const withTexts = (code, uses) =>
  uses
    .sort(([a], [b]) => b.start - a.start)
    .reduce((text, [{ start, end }, use]) => text.slice(0, start) + use + text.slice(end), code);

/** The terms of a sum. */
const termsOf = (node) =>
  node.type === 'BinaryExpression' && node.operator === '+'
    ? [...termsOf(node.left), ...termsOf(node.right)]
    : [node];

const isWhole = ({ type, value }) => type === 'Literal' && Number.isSafeInteger(value);

/** `[index, text]` for each index with several whole numbers, or with 0. */
function sumsIn(node, code) {
  if (node === null || typeof node !== 'object') return [];
  const inside = (Array.isArray(node) ? node : Object.values(node)).flatMap((value) => sumsIn(value, code));
  if (node.type !== 'MemberExpression' || !node.computed) return inside;
  const terms = termsOf(node.property);
  const numbers = terms.filter(isWhole).map(({ value }) => value);
  if (terms.length === 1 || !(numbers.length > 1 || numbers[0] === 0)) return inside;
  const sum = numbers.reduce((a, b) => a + b);
  const others = terms.filter((term) => !isWhole(term)).map(({ start, end }) => code.slice(start, end));
  return [
    ...inside,
    [node.property, [...others, ...(sum === 0 && others.length > 0 ? [] : [sum])].join(' + ')],
  ];
}

/** The code with the whole numbers of each index added up: exact, since indices are whole. No line moves. */
export function addIndices(code) {
  return withTexts(code, sumsIn(parseAst(code), code));
}

/** The vite plugin, for modules of the folder `src` alone. */
export const numbers = (src) => ({
  name: 'inline-numbers',
  enforce: 'post',
  transform: (code, id) =>
    // No line moves, so the source map stays valid to the line.
    id.startsWith(src) && id.endsWith('.ts') ? { code: inlineNumbers(code), map: null } : null,
  // Here the bundler has inlined the constants of other modules too.
  renderChunk: (code) => ({ code: addIndices(code), map: null }),
});
