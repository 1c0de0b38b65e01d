// Which blocks of the source a test file runs: each block reports itself once per file.
import { parseSync } from 'vite';

const FUNCTIONS = /^(FunctionDeclaration|FunctionExpression|ArrowFunctionExpression)$/;

/** Bodies of functions, and the blocks inside them: [{ start, end, isExpression }] in the order of their starts. */
export function blocksOf(path, text) {
  const found = [];
  const visit = (node, isInside) => {
    const isFunction = FUNCTIONS.test(node.type) && node.body !== null;
    if (isFunction && node.expression) found.push({ ...placeOf(node.body), isExpression: true });
    else if (isInside && node.type === 'BlockStatement')
      found.push({ ...placeOf(node), isExpression: false });
    for (const value of Object.values(node))
      for (const child of Array.isArray(value) ? value : [value])
        if (child && typeof child.type === 'string') visit(child, isInside || isFunction);
  };
  visit(parseSync(path, text).program, false);
  return found.sort((a, b) => a.start - b.start);
}

const placeOf = ({ start, end }) => ({ start, end });

/** Index of the innermost block around a place; -1 at the top of the module. */
export function blockAt(blocks, start) {
  return blocks.findLastIndex((block) => block.start <= start && start < block.end);
}

/** The source with a report `touchdownReport(path, index)` at the begin of each block; its lines stay where they are. */
export function withProbes(path, text) {
  const insertions = blocksOf(path, text).flatMap(({ start, end, isExpression }, index) =>
    isExpression
      ? [
          { at: start, text: `(touchdownReached(${index}), ` },
          { at: end, text: ')' },
        ]
      : [{ at: start + 1, text: ` touchdownReached(${index});` }],
  );
  if (insertions.length === 0) return text;
  const last = insertions
    .sort((a, b) => a.at - b.at)
    .reduce(
      ({ done, made }, { at, text: inserted }) => ({
        done: at,
        made: made + text.slice(done, at) + inserted,
      }),
      { done: 0, made: '' },
    );
  return reporter(path, insertions.length) + last.made + text.slice(last.done);
}

const reporter = (path, count) =>
  `const touchdownSeen = new Uint8Array(${count}); (globalThis.touchdownSeen ??= []).push(touchdownSeen); ` +
  'const touchdownReached = (index) => { if (touchdownSeen[index] !== 0) return; touchdownSeen[index] = 1; ' +
  `globalThis.touchdownReport?.(${JSON.stringify(path)}, index); }; `;

/**
 * The module of a test file whose tests are in the bundle at `url`. It appends a line to the file `into`: { test, loading, running },
 * the blocks that loading it and its tests ran, as "path:index". Processes load shared modules once, with the first file that needs them.
 */
export function reportingTest(test, url, into) {
  return `
    import { appendFileSync } from 'node:fs';
    import { afterAll } from 'vitest';
    const collect = () => {
      const blocks = new Set();
      for (const seen of globalThis.touchdownSeen ?? []) seen.fill(0);
      globalThis.touchdownReport = (path, index) => blocks.add(path + ':' + index);
      return blocks;
    };
    const loading = collect();
    await import(${JSON.stringify(url)});
    const running = collect();
    afterAll(() => {
      const line = { test: ${JSON.stringify(test)}, loading: [...loading], running: [...running] };
      appendFileSync(${JSON.stringify(into)}, JSON.stringify(line) + '\\n');
    });
  `;
}
