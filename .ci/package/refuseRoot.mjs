// `npm pack` and `npm publish` in the root would pack the sources, which nothing can import.
console.error(`The package is built, not this folder:
  npm run build
  npm pack ./dist/package`);
process.exit(1);
