// Prints "N passed, N failed" from vitest's JSON reports, and fails when a test failed, was skipped or none ran.
//   node .ci/count.mjs REPORT.json …
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

/** The final line of the reports, and a complaint if CI must fail, or null. */
export function verdictOf(reports) {
  const sum = (name) => reports.reduce((total, report) => total + report[name], 0);
  const [numPassedTests, numFailedTests] = [sum('numPassedTests'), sum('numFailedTests')];
  const skipped = sum('numPendingTests') + sum('numTodoTests');
  const line =
    `${numPassedTests} passed, ${numFailedTests} failed` + (skipped > 0 ? `, ${skipped} skipped` : '');
  if (reports.some((report) => report.numPassedTests === 0))
    return { line, complaint: 'no test of a report passed' };
  if (numFailedTests > 0) return { line, complaint: 'tests failed' };
  if (skipped > 0) return { line, complaint: 'nothing may be skipped here' };
  // A file that does not load fails without a failed test.
  return {
    line,
    complaint: reports.every(({ success }) => success) ? null : 'a test file or a set-up failed',
  };
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const reports = process.argv.slice(2).map((path) => JSON.parse(readFileSync(path, 'utf8')));
  const { line, complaint } = verdictOf(reports);
  if (complaint) console.error(`count: ${complaint}`);
  console.log(line);
  if (complaint) process.exit(1);
}
