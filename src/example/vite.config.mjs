// `npm run example`: the example as a page, with the package's doors where its sources are.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here('.'),
  cacheDir: here('../../node_modules/.vite/example'),
  resolve: {
    alias: [
      { find: 'galaxy-touchdown/hud.css', replacement: here('../hud/styles/hud.css') },
      { find: 'galaxy-touchdown/hud', replacement: here('../hud/index.ts') },
      { find: 'galaxy-touchdown/game', replacement: here('../game/index.ts') },
      { find: 'galaxy-touchdown', replacement: here('../index.ts') },
    ],
  },
  server: { port: 5174, fs: { allow: [here('../..')] } },
});
