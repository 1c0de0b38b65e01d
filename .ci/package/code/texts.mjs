// Shortens the texts of the production build: a warning's message is its code, and a refusal is `field: got value`.
// ERRORS.md has the sentences by code, and the development build's texts name what was expected. Warnings of a caller's mistakes are left out.
import { parseAst } from 'vite';

/** Calls `visit` with each node below `node`. */
function walk(node, visit) {
  if (node === null || typeof node !== 'object') return;
  if (typeof node.type === 'string') visit(node);
  for (const value of Array.isArray(node) ? node : Object.values(node)) walk(value, visit);
}

const isText = (node) =>
  node?.type === 'TemplateLiteral' || (node?.type === 'Literal' && typeof node.value === 'string');

/** Codes of mistakes that a caller makes with the first call, not with data: found in development. */
const OF_DEVELOPMENT = new Set([
  'tempo-missing',
  'listener-not-function',
  'ship-id',
  'removal-unknown',
  'disposed',
]);

const nameOf = ({ callee }) => (callee.type === 'MemberExpression' ? callee.property : callee).name;

/** `warn(code, message, details)` with the code as its message, `carriesOut()` without the call's name; null for any other call. */
function shortWarning(node, code) {
  if (node.type !== 'CallExpression') return null;
  const [first, message] = node.arguments;
  if (nameOf(node) === 'carriesOut' && isText(first)) return [first.start, first.end, ''];
  if (nameOf(node) !== 'warn') return null;
  if (!isText(first) || !isText(message)) return null;
  return [message.start, message.end, code.slice(first.start, first.end)];
}

/** `[start, end, text]` to leave out a warning of development, with a condition that serves only it; null for any other statement. */
function withoutWarning({ type, start, end, expression, consequent, alternate }) {
  if (type === 'IfStatement' && !alternate && consequent.type === 'ExpressionStatement')
    return withoutWarning({ ...consequent, start, end });
  if (type !== 'ExpressionStatement' || expression.type !== 'CallExpression') return null;
  const isLeftOut = nameOf(expression) === 'warn' && OF_DEVELOPMENT.has(expression.arguments[0].value);
  return isLeftOut ? [start, end, ';'] : null;
}

/** `[start, end, text]` to leave out what a text expected; null if it has no such part. */
function shortReason(node, code) {
  if (!isText(node)) return null;
  const parts = node.type === 'Literal' ? [node] : node.quasis;
  const find = (word, from) => {
    for (const { start, end } of parts) {
      const at = code.slice(start, end).indexOf(word, Math.max(0, from - start));
      if (at >= 0 && start + at >= from) return start + at;
    }
    return -1;
  };
  const from = find('expected ', node.start);
  if (from < 0) return null;
  const got = find('got ', from);
  return got < 0 ? [from, node.end - 1, 'refused'] : [from, got, ''];
}

/** `[start, end, text]` to shorten `field: no terrain named ${name}`; null for any other text. */
function shortUnknown({ type, quasis }, code) {
  const first = type === 'TemplateLiteral' ? quasis[0] : undefined;
  const found = first && /no \w+ named $/.exec(code.slice(first.start, first.end));
  return found ? [first.start + found.index, first.end, 'got '] : null;
}

/** `[start, end, '']` to leave out the unit, the last member of a range, which only such texts use; null for anything else. */
function withoutUnit({ type, properties }) {
  const [before, last] = type === 'ObjectExpression' ? properties.slice(-2) : [];
  return last?.key?.name === 'unit' && isText(last.value) ? [before.end, last.end, ''] : null;
}

/** The code with short texts; no line is added. */
export function shortenTexts(code) {
  const changes = [];
  walk(parseAst(code), (node) =>
    changes.push(
      withoutWarning(node) ??
        shortWarning(node, code) ??
        shortReason(node, code) ??
        shortUnknown(node, code) ??
        withoutUnit(node),
    ),
  );
  const found = changes.filter((change) => change !== null);
  const isInside = ([start, end], other) =>
    start >= other[0] && end <= other[1] && end - start < other[1] - other[0];
  return found
    .filter((change) => !found.some((other) => isInside(change, other)))
    .sort(([a], [b]) => b - a)
    .reduce((text, [start, end, short]) => text.slice(0, start) + short + text.slice(end), code);
}

/** The vite plugin, for modules of the core in the folder `src`. */
export const texts = (src) => ({
  name: 'short-texts',
  enforce: 'post',
  transform: (code, id) =>
    id.startsWith(src) && /\/(dynamics|wire|prediction|readout|protocol)\/.*\.ts$/.test(id)
      ? { code: shortenTexts(code), map: null }
      : null,
});
