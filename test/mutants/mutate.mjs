// Small changes to a TypeScript source that its tests should detect.
import { parseSync } from 'vite';

const SWAPS = {
  '+': '-',
  '-': '+',
  '*': '/',
  '/': '*',
  '<': '<=',
  '<=': '<',
  '>': '>=',
  '>=': '>',
  '===': '!==',
  '!==': '===',
  '&&': '||',
  '||': '&&',
  '??': '&&',
  '+=': '-=',
  '-=': '+=',
  '*=': '/=',
  '++': '--',
  '--': '++',
  min: 'max',
  max: 'min',
  true: 'false',
  false: 'true',
};

const TYPED_ARRAY = /^(Float|Int|Uint|BigInt|BigUint)\d+(Clamped)?Array$/;

/** Nodes whose contents are not changed: types, error texts, and module paths. */
const LEFT_ALONE =
  /^(TS(Type|Interface|Enum|Declare)|Import|TemplateLiteral$|ThrowStatement$|ExportAll)|TypeAnnotation$|TypeParameter/;

/** The operator's place: between its operands. */
function operatorPlace({ left, right, operator }, text) {
  const start = text.indexOf(operator, left.end);
  return start >= 0 && start < right.start ? { start, end: start + operator.length } : null;
}

/** What may be changed at a node: { start, end, text }, or null. */
function changeAt(node, text) {
  switch (node.type) {
    case 'BinaryExpression':
    case 'LogicalExpression':
    case 'AssignmentExpression': {
      const swap = SWAPS[node.operator];
      const place = swap && operatorPlace(node, text);
      return place ? { ...place, text: swap } : null;
    }
    case 'UpdateExpression': {
      const start = node.prefix ? node.start : node.end - 2;
      return { start, end: start + 2, text: SWAPS[node.operator] };
    }
    case 'UnaryExpression':
      return node.operator === '!' || node.operator === '-'
        ? { start: node.start, end: node.start + 1, text: '' }
        : null;
    case 'Literal':
      if (typeof node.value === 'number')
        return { start: node.start, end: node.end, text: String(another(node.value)) };
      return typeof node.value === 'boolean'
        ? { start: node.start, end: node.end, text: SWAPS[node.value] }
        : null;
    case 'ConditionalExpression':
    case 'IfStatement':
      return {
        start: node.test.start,
        end: node.test.end,
        text: `!(${text.slice(node.test.start, node.test.end)})`,
      };
    case 'ExpressionStatement':
      // A call or an assignment that is left out; a directive is none.
      return node.directive ? null : { start: node.start, end: node.end, text: ';' };
    case 'NewExpression': {
      // One less: a longer array behaves the same.
      const [length] = node.arguments;
      return TYPED_ARRAY.test(node.callee.name) && typeof length?.value === 'number'
        ? { start: length.start, end: length.end, text: String(length.value - 1) }
        : null;
    }
    case 'MemberExpression':
      return node.object.name === 'Math' && SWAPS[node.property.name]
        ? { start: node.property.start, end: node.property.end, text: SWAPS[node.property.name] }
        : null;
    default:
      return null;
  }
}

/** One more; above 2⁵³, where that may be the same double, twice as much. */
const another = (value) => (value + 1 === value ? 2 * value : value + 1);

/** All single changes of a source: [{ start, end, text, line, says }], in its order. `says` is like "a < b → a <= b". */
export function changesOf(path, text) {
  const { program, errors } = parseSync(path, text);
  if (errors[0]) throw new Error(`${path}: ${errors[0].message}`);
  const found = [];
  const visit = (node) => {
    if (LEFT_ALONE.test(node.type)) return;
    const change = changeAt(node, text);
    if (change) found.push(describe(change, text));
    if (change && node.type === 'NewExpression') return;
    for (const value of Object.values(node))
      for (const child of Array.isArray(value) ? value : [value])
        if (child && typeof child.type === 'string') visit(child);
  };
  visit(program);
  return found.sort((a, b) => a.start - b.start || a.end - b.end);
}

function describe(change, text) {
  const line = text.slice(0, change.start).split('\n').length;
  const begin = text.lastIndexOf('\n', change.start) + 1;
  const stop = (text + '\n').indexOf('\n', change.end);
  const before = text.slice(begin, stop).trim();
  const after = (text.slice(begin, change.start) + change.text + text.slice(change.end, stop)).trim();
  return { ...change, line, says: `${shorten(before)}  →  ${shorten(after)}` };
}

const shorten = (code) => {
  const flat = code.replace(/\s+/g, ' ');
  return flat.length > 90 ? `${flat.slice(0, 89)}…` : flat;
};

/** `count` of the items, drawn by the seed; all of them where there are fewer. */
export function sampleOf(items, count, seed) {
  const left = [...items];
  const drawn = [];
  let state = seed >>> 0;
  while (drawn.length < count && left.length > 0) {
    // mulberry32
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    drawn.push(...left.splice(((mixed ^ (mixed >>> 14)) >>> 0) % left.length, 1));
  }
  return drawn;
}
