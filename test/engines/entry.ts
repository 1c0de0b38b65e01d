/** The script that every engine runs: one line per case, "name substeps hash", then "all hash". */
import { caseHashes, hexadecimal, trajectoryHash } from './hash';

/** Shells print with `print`, the others with the console. */
const shell = globalThis as { print?: (line: string) => void };

const hashes = caseHashes();
const lines = hashes.map(({ name, substeps, hash }) => `${name} ${substeps} ${hexadecimal(hash)}`);
const text = [...lines, `all ${trajectoryHash(hashes)}`].join('\n');
if (typeof shell.print === 'function') shell.print(text);
else console.log(text);
