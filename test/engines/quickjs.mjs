// Runs a classic script in QuickJS, compiled to WebAssembly:
//   node quickjs.mjs SCRIPT.js PACKAGE-FOLDER [VARIANT-FOLDER]
// PACKAGE-FOLDER is quickjs-emscripten's, VARIANT-FOLDER another build of the engine.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const [script, packageFolder, variantFolder] = process.argv.slice(2);
const require = createRequire(join(packageFolder, 'package.json'));
const quickjs = require('quickjs-emscripten');
const variant = variantFolder ? require(variantFolder) : quickjs.RELEASE_SYNC;
const engine = await quickjs.newQuickJSWASMModuleFromVariant(variant.default ?? variant);

const context = engine.newContext();
const print = context.newFunction('print', (text) => console.log(context.getString(text)));
context.setProp(context.global, 'print', print);
const result = context.evalCode(readFileSync(script, 'utf8'), 'trajectories.js');
if (result.error) {
  console.error(context.dump(result.error));
  process.exitCode = 1;
}
