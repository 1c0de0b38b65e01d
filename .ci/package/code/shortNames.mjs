// Shortens the names of the core's internal properties in the production build: the users' minifiers may not, since they
// cannot know which names are public. A name is kept if it is a member in a declaration file, a whole string, a property in
// another entry's code, or of JavaScript itself (the core uses no browser API).
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';
import { parseAst } from 'vite';

const isWord = (text) => /^[A-Za-z_$][\w$]*$/.test(text);

/** Names of the members that a declaration file declares, and its literal types. */
function membersOf(text) {
  const found = [];
  const visit = (node) => {
    if (ts.isStringLiteral(node)) found.push(node.text);
    else if (
      (ts.isTypeElement(node) || ts.isClassElement(node) || ts.isEnumMember(node)) &&
      node.name !== undefined
    )
      found.push(node.name.text);
    ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile('members.d.ts', text, ts.ScriptTarget.Latest));
  return found;
}

/** Calls `visit` with each node of a program. */
function eachNode(node, visit) {
  if (node === null || typeof node !== 'object') return;
  if (typeof node.type === 'string') visit(node);
  for (const value of Array.isArray(node) ? node : Object.values(node)) eachNode(value, visit);
}

const KEYED = new Set(['Property', 'MethodDefinition', 'PropertyDefinition']);

/** The identifier that names a property at `node`, or undefined. */
function nameAt(node) {
  if (node.computed) return undefined;
  const name = node.type === 'MemberExpression' ? node.property : KEYED.has(node.type) ? node.key : undefined;
  return name?.type === 'Identifier' ? name : undefined;
}

/** Property names of a file, `{ name, start, end, isShorthand }` each, and its strings that are one word. */
function read(path) {
  const code = readFileSync(path, 'utf8');
  const names = [];
  const texts = [];
  eachNode(parseAst(code), (node) => {
    if (node.type === 'Literal' && typeof node.value === 'string') texts.push(node.value);
    const found = nameAt(node);
    if (found === undefined) return;
    names.push({
      name: found.name,
      start: found.start,
      end: found.end,
      isShorthand: node.shorthand === true,
    });
  });
  return { path, code, names, texts: texts.filter(isWord) };
}

/** The letters in the order in which minifiers give them to variables: what these already repeat costs least in a compressed bundle. */
const ALPHABET = 'tneosiraculfdpgybmhvwkxjqz';

/** One letter, then two: those of common letters first. */
function* names() {
  for (const a of ALPHABET) yield a;
  const letters = [...ALPHABET];
  const pairs = letters.flatMap((a, i) => letters.map((b, j) => ({ name: a + b, rank: (i + 1) * (j + 1) })));
  for (const { name } of pairs.sort((p, q) => p.rank - q.rank)) yield name;
  throw new Error('more names than two letters can tell apart');
}

/** A short name for each name that may change, the most used first. */
function shortNames(files, kept) {
  const counts = new Map();
  for (const { name } of files.flatMap(({ names }) => names)) counts.set(name, (counts.get(name) ?? 0) + 1);
  const free = names();
  const next = () => {
    let name = free.next().value;
    while (kept.has(name) || counts.has(name)) name = free.next().value;
    return name;
  };
  const changing = [...counts].filter(([name]) => !kept.has(name) && name.length > 2);
  return new Map(
    changing.sort(([a, m], [b, n]) => n - m || (a < b ? -1 : 1)).map(([name]) => [name, next()]),
  );
}

function rewrite({ path, code, names }, short) {
  const changed = names
    .filter(({ name }) => short.has(name))
    .sort((a, b) => b.start - a.start)
    .reduce((text, { name, start, end, isShorthand }) => {
      const use = isShorthand ? `${short.get(name)}: ${name}` : short.get(name);
      return text.slice(0, start) + use + text.slice(end);
    }, code);
  // No line moves, so the source map stays valid to the line.
  writeFileSync(path, changed);
}

/**
 * Rewrites the core in `folder` (index.js and the chunks). `own` are the texts of the package's declaration files, `language` of
 * JavaScript's. Throws if there is almost nothing to shorten: then the lists are wrong.
 */
export function shortenNames(folder, { own, language }) {
  const list = (path) => readdirSync(path).filter((file) => file.endsWith('.js'));
  const chunks = list(join(folder, 'chunks')).map((file) => join(folder, 'chunks', file));
  const others = list(folder).filter((file) => file !== 'index.js');
  const files = [join(folder, 'index.js'), ...chunks].map(read);
  const outside = others.map((file) => read(join(folder, file)));
  const kept = new Set([
    ...[...own, ...language].flatMap(membersOf),
    ...[...files, ...outside].flatMap(({ texts }) => texts),
    ...outside.flatMap(({ names }) => names).map(({ name }) => name),
  ]);
  const short = shortNames(files, kept);
  if (short.size < 100) throw new Error(`only ${short.size} names may be shortened`);
  for (const file of files) rewrite(file, short);
}
