// Bundles entry.ts into one classic script without imports, in the language of 2015, for shells without modules.
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** Writes the script into the folder `outDir` and returns its path. */
export async function bundleScript(outDir) {
  await build({
    configFile: false,
    root,
    logLevel: 'warn',
    publicDir: false,
    build: {
      outDir,
      emptyOutDir: true,
      target: 'es2015',
      minify: false,
      rolldownOptions: {
        input: join(root, 'test/engines/entry.ts'),
        // Only the code that the hash needs, without the codec and the like.
        treeshake: { moduleSideEffects: [join(root, 'test/engines/entry.ts')] },
        output: { format: 'iife', entryFileNames: 'trajectories.js', codeSplitting: false },
      },
    },
  });
  return join(outDir, 'trajectories.js');
}
