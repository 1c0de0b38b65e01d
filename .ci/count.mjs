// Prints "N passed, N failed" from vitest's JSON report, and fails when a test failed, was skipped or none ran.
//   node .ci/count.mjs REPORT.json
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

/** The closing line of a report, and why it is not good enough, or null. */
export function verdictOf(report) {
  const { numPassedTests, numFailedTests, numPendingTests, numTodoTests, success } = report;
  const skipped = numPendingTests + numTodoTests;
  const line =
    `${numPassedTests} passed, ${numFailedTests} failed` + (skipped > 0 ? `, ${skipped} skipped` : '');
  if (numPassedTests === 0) return { line, complaint: 'no test passed' };
  if (numFailedTests > 0) return { line, complaint: 'tests failed' };
  if (skipped > 0) return { line, complaint: 'nothing may be skipped here' };
  // A file that does not load fails without a test of its own.
  return { line, complaint: success ? null : 'a test file or a set-up failed' };
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const { line, complaint } = verdictOf(JSON.parse(readFileSync(process.argv[2], 'utf8')));
  if (complaint) console.error(`count: ${complaint}`);
  console.log(line);
  if (complaint) process.exit(1);
}
