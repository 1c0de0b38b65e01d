// What the build puts into the page's service worker: the list of its files, and a version that changes with any of them.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** The service worker's file in the build: its name may not change from build to build. */
export const OFFLINE_SCRIPT = 'offline.js';

/** A plugin of the build; `publicFolder` is copied into it as it is. */
export function listForOffline(publicFolder) {
  return {
    name: 'list-for-offline',
    apply: 'build',
    enforce: 'post',
    generateBundle(_options, bundle) {
      const script = bundle[OFFLINE_SCRIPT];
      if (script?.type !== 'chunk') throw new Error(`there is no ${OFFLINE_SCRIPT} in the build`);
      if (script.imports.length > 0) throw new Error(`${OFFLINE_SCRIPT} imports, and is no module`);
      const hash = createHash('sha256').update(script.code);
      const files = [];
      for (const output of Object.values(bundle)) {
        if (output === script) continue;
        hash.update(output.fileName).update(output.type === 'chunk' ? output.code : output.source);
        // The document is kept under its folder's address.
        if (!/\.(html|map)$/.test(output.fileName)) files.push(output.fileName);
      }
      // Of the files copied as they are the page uses those at the top; the folders are the README's.
      for (const entry of readdirSync(publicFolder, { withFileTypes: true })) {
        if (!entry.isFile()) continue;
        hash.update(entry.name).update(readFileSync(join(publicFolder, entry.name)));
        files.push(entry.name);
      }
      script.code =
        `const OFFLINE_FILES = ${JSON.stringify(files.sort())};\n` +
        `const OFFLINE_VERSION = ${JSON.stringify(hash.digest('hex').slice(0, 16))};\n${script.code}`;
    },
  };
}
