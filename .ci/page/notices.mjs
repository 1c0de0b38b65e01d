// Writes the licences of the packages in the built page to notices.txt beside it: most must be distributed with copies.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

/** The page's notices, named in its help. */
export const NOTICES = 'notices.txt';

/** The folder of the package that a bundled module is from, or null for the page's own. */
function packageFolder(id) {
  const path = id.split('?')[0].replaceAll('\\', '/');
  if (!path.includes('/node_modules/')) return null;
  let folder = dirname(path);
  // Folders inside a package may have their own package.json, without a version.
  while (folder.includes('/node_modules/')) {
    const manifest = join(folder, 'package.json');
    if (existsSync(manifest) && JSON.parse(readFileSync(manifest, 'utf8')).version) return folder;
    folder = dirname(folder);
  }
  return null;
}

/** "name version (licence)" and the licence's text. @throws if a package has none: it could not be distributed */
function noticeOf(folder) {
  const { name, version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((entry) => /^(licen[cs]e|copying)(\.\w+)?$/i.test(entry));
  if (file === undefined) throw new Error(`${name} ${version} has no licence file`);
  return `${name} ${version} (${license})\n\n${readFileSync(join(folder, file), 'utf8').trim()}\n`;
}

/** A plugin of the build. */
export function writeNotices() {
  const folders = new Set();
  return {
    name: 'write-notices',
    apply: 'build',
    generateBundle(_options, bundle) {
      for (const output of Object.values(bundle))
        for (const id of output.moduleIds ?? []) {
          const folder = packageFolder(id);
          if (folder !== null) folders.add(folder);
        }
      const notices = [...folders].map(noticeOf).sort();
      const source = `Touchdown contains the following software.\n\n${notices.join(`\n${'-'.repeat(80)}\n\n`)}`;
      this.emitFile({ type: 'asset', fileName: NOTICES, source });
    },
  };
}
