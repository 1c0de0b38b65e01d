/** Forbidden names by folder, and their check in one file's syntax tree. */
import { placeOf, visitTree } from '../source';
import type { Node, SourceFile } from '../source';

/** Names that are forbidden in some files, with the reason. */
interface Rule {
  readonly where: RegExp;
  readonly names: ReadonlySet<string>;
  readonly reason: string;
}

function names(text: string): ReadonlySet<string> {
  return new Set(text.split(/\s+/));
}

/** Exact on every machine: IEEE 754 requires a correctly rounded square root, and the others only select or truncate. */
const EXACT_MATH = names('sqrt abs min max ceil floor trunc sign imul PI');

const RULES: readonly Rule[] = [
  {
    where: /^src\//,
    names: names('innerHTML outerHTML insertAdjacentHTML setHTMLUnsafe createContextualFragment srcdoc'),
    reason: 'text is never markup',
  },
  { where: /^src\//, names: names('eval Function'), reason: 'the content security policy forbids it' },
  {
    where: /^src\/(?!playground\/|example\/|gateway\/main)/,
    names: names('Date performance random crypto'),
    reason: 'no clock and no random numbers below the page: they are arguments',
  },
  {
    where: /^src\/dynamics\//,
    names: names('setTimeout setInterval queueMicrotask requestAnimationFrame process fetch Intl'),
    reason: 'a step depends on its arguments alone',
  },
  {
    where: /^src\/dynamics\//,
    names: names('toFixed toPrecision toExponential toLocaleString Float32Array fround'),
    reason: 'doubles stay whole',
  },
  {
    where: /^src\/dynamics\//,
    // Functions of gl-matrix that are transcendental, or that change its array type globally.
    names: names(
      'setMatrixArrayType rotationTo getAxisAngle setAxisAngle slerp sqlerp fromEuler rotateX rotateY rotateZ',
    ),
    reason: 'only + - * / and the square root give the same bits everywhere',
  },
];

const DYNAMICS = /^src\/dynamics\//;

/** The name that a node writes, whichever way: `x.name`, `name`, `x['name']`. */
function nameAt(node: Node, parent: Node | null): string | null {
  if (node.type === 'Identifier') return node['name'] as string;
  const isKey = parent?.type === 'MemberExpression' && parent['property'] === node;
  return node.type === 'Literal' && isKey && typeof node['value'] === 'string' ? node['value'] : null;
}

/** A type such as `Function` or `Date` in an annotation has no run-time effect. */
function isInType(parent: Node | null): boolean {
  return parent?.type === 'TSTypeReference' || parent?.type === 'TSQualifiedName';
}

/** `Math` may only be the object of an exact member. */
function isInexactMath(node: Node, parent: Node | null): boolean {
  if (node.type !== 'Identifier' || node['name'] !== 'Math') return false;
  if (parent?.type !== 'MemberExpression' || parent['object'] !== node || parent['computed'] === true)
    return true;
  return !EXACT_MATH.has((parent['property'] as Node)['name'] as string);
}

/** "place name: reason" for each forbidden word in `file`. */
export function wordFaults(file: SourceFile): string[] {
  const rules = RULES.filter((rule) => rule.where.test(file.path));
  const inDynamics = DYNAMICS.test(file.path);
  const faults: string[] = [];
  visitTree(file, (node, parent) => {
    const said = (what: string) => faults.push(`${placeOf(file, node.start)} ${what}`);
    const name = isInType(parent) ? null : nameAt(node, parent);
    for (const rule of rules) if (name !== null && rule.names.has(name)) said(`${name}: ${rule.reason}`);
    if (!inDynamics) return;
    if (isInexactMath(node, parent)) said('Math: its other functions differ between engines');
    if (node['operator'] === '**' || node['operator'] === '**=') said('**: differs between engines');
  });
  return faults;
}

/** Names that say nothing about the contents. */
export function isEmptyName(path: string): boolean {
  const words = path
    .replace(/([a-z0-9])([A-Z])/g, '$1 $2')
    .toLowerCase()
    .split(/[^a-z0-9]+/);
  return words.some((word) =>
    /^(utils?|utilit(y|ies)|helpers?|managers?|misc|miscellaneous|stuff)$/.test(word),
  );
}
