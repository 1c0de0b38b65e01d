// The verdict on the engines' hashes.

const FEWEST_FAMILIES = 3;

/** The hash in an engine's last line, "all 01234567". */
function hashOf(lines) {
  return lines.at(-1)?.replace(/^all /, '') ?? '';
}

/** The first line that differs from the reference, or null. */
function firstDifference(lines, reference) {
  const at = reference.findIndex((line, i) => lines[i] !== line);
  if (at >= 0) return `${lines[at] ?? 'nothing'}, not ${reference[at]}`;
  return lines.length === reference.length ? null : `${lines.length} lines, not ${reference.length}`;
}

/** The line of one engine, and whether it failed. */
export function describeAnswer({ family, label = '', missing, failure, lines }, reference) {
  const line = (said) => `${family.padEnd(15)} ${label.padEnd(20)} ${said}`;
  if (missing) return { line: line(`skipped: ${missing}`), agrees: false, fails: false };
  if (failure) return { line: line(`failed: ${failure}`), agrees: false, fails: true };
  const difference = firstDifference(lines, reference);
  if (difference === null) return { line: line(hashOf(lines)), agrees: true, fails: false };
  return { line: line(`${hashOf(lines)}  DIFFERS: ${difference}`), agrees: false, fails: true };
}

/**
 * The last lines, and the complaints: none means success.
 * @param answers one an engine: family, and missing, failure or lines; the first with lines is the reference
 * @param pinned the hash that the project expects
 */
export function verdictOf(answers, pinned) {
  const reference = answers.find(({ lines }) => lines)?.lines ?? [];
  const described = answers.map((answer) => ({ ...answer, ...describeAnswer(answer, reference) }));
  const families = [...new Set(described.filter(({ agrees }) => agrees).map(({ family }) => family))];
  const complaints = described.filter(({ fails }) => fails).map(({ line }) => line);
  if (hashOf(reference) !== pinned) {
    complaints.push(`test/engines/hash.ts pins ${pinned}, here it is ${hashOf(reference) || 'nothing'}`);
  }
  if (families.length < FEWEST_FAMILIES)
    complaints.push(`fewer than ${FEWEST_FAMILIES} engine families agree`);
  const landings = Math.max(0, reference.length - 1);
  return {
    summary: `${families.length} families agree on ${landings} landings: ${families.join(', ')}`,
    complaints,
  };
}
