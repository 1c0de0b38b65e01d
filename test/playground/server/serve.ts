import { startSocketServer } from './socketServer';

// node test/run.mjs test/playground/server/serve.ts [SCENARIO] [PORT]
// A real server for the page's `?server=ws://127.0.0.1:PORT`: each client flies a ship of the scenario.

const [scenario = 'opening', port = '8787'] = process.argv.slice(2);
const server = await startSocketServer(scenario, {}, Number(port));
console.log(`${scenario} at ${server.address}`);
