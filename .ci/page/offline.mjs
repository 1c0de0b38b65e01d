// Puts the list of the build's files with their hashes, and a version that changes with any of them, into the page's service worker.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** The service worker's file in the build: its name must not change between builds. */
export const OFFLINE_SCRIPT = 'offline.js';

const sha256 = (bytes) => createHash('sha256').update(bytes);

/** The first line of a build's offline.js: `files` by address relative to the document, '' being the document. */
function listOf(files, script) {
  const version = sha256(script).update(JSON.stringify(files)).digest('hex').slice(0, 16);
  return `const OFFLINE_FILES = ${JSON.stringify(files)};\nconst OFFLINE_VERSION = ${JSON.stringify(version)};\n`;
}

/** A plugin of the build; `publicFolder` is copied into it as it is. */
export function listForOffline(publicFolder) {
  return {
    name: 'list-for-offline',
    apply: 'build',
    // Reads the files as served: vite still changes chunks after the last hook that sees them in memory.
    writeBundle({ dir }, bundle) {
      const script = bundle[OFFLINE_SCRIPT];
      if (script?.type !== 'chunk') throw new Error(`there is no ${OFFLINE_SCRIPT} in the build`);
      if (script.imports.length > 0) throw new Error(`${OFFLINE_SCRIPT} has imports, but is not a module`);
      const built = Object.keys(bundle).filter((name) => name !== OFFLINE_SCRIPT && !name.endsWith('.map'));
      // Of the copied files the page uses those at the top; the folders are for the README.
      const copied = readdirSync(publicFolder, { withFileTypes: true })
        .filter((entry) => entry.isFile())
        .map((entry) => entry.name);
      const files = {};
      for (const name of [...built, ...copied].sort()) {
        // The document is stored under its folder's address.
        files[name === 'index.html' ? '' : name] =
          `sha256-${sha256(readFileSync(join(dir, name))).digest('base64')}`;
      }
      const path = join(dir, OFFLINE_SCRIPT);
      const code = readFileSync(path, 'utf8');
      writeFileSync(path, listOf(files, code) + code);
    },
  };
}
