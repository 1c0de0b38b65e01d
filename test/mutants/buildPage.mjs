// Builds the page with the change of test/mutants/main.mjs:  node test/mutants/buildPage.mjs FOLDER
import { build } from 'vite';
import { mutation } from './plugins.mjs';

await build({
  logLevel: 'error',
  plugins: mutation(),
  worker: { plugins: mutation },
  build: { outDir: process.argv[2], emptyOutDir: true },
});
