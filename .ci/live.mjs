// The whole stack on this machine: Redis, physics service, gateway and page, for two pilots.
//   npm run live                     at 1 Hz, the game's own rate
//   npm run live -- --rate 10        at another rate
//   npm run live -- --help           ports, data folder, check
// Ends with Ctrl-C. A process that dies is restarted, and the flight continues.
import { randomBytes } from 'node:crypto';
import { createClient } from 'redis';
import { createServer } from 'vite';
import { readOptions, USAGE } from './liveOptions.mjs';
import { requireFree } from './ports.mjs';
import { createStack } from './stack.mjs';

const PILOTS = ['one', 'two'];
/** Where the pilots' ships begin: over level ground on the moon, high enough to bounce. */
const HANGAR = {
  body: 'Luna',
  direction: [0.6, 0.48, 0.64],
  height: 60,
  ship_class: 'planetary_lander',
  delay: 5,
};
/** ms before a dead process is restarted. */
const AGAIN = 500;

function stop(message) {
  console.error(`live: ${message}`);
  process.exit(1);
}

let isEnding = false;

/** Restarts the process whenever it dies by itself. */
function keepUp(process) {
  const again = () => {
    if (!isEnding) process.start().catch((error) => console.error(`live: ${error.message}`));
  };
  process.whenItDies((how) => {
    console.log(`live: ${process.name} ended (${how}); starting it again …`);
    setTimeout(again, AGAIN);
  });
}

async function signIn(port, username, password) {
  const response = await fetch(`http://127.0.0.1:${port}/api/auth/login`, {
    method: 'POST',
    body: JSON.stringify({ username, password }),
  });
  const body = await response.json();
  if (!response.ok) throw new Error(body.error.message);
  return body.token;
}

async function setRate(redisUrl, rate) {
  const redis = createClient({ url: redisUrl });
  redis.on('error', () => undefined);
  await redis.connect();
  await redis.set('game:tick_rate', String(rate));
  await redis.close();
}

/** Waits until the gateway has seen a tick of the service. @throws after half a minute */
async function untilTicking(url) {
  const until = Date.now() + 30_000;
  while (Date.now() < until) {
    if ((await (await fetch(url)).json()).tick !== null) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`${url}: no tick within 30 s`);
}

function optionsOf(args) {
  try {
    return readOptions(args);
  } catch (error) {
    return stop(`${error.message}\n\n${USAGE}`);
  }
}

const { rate, ports, data, isCheck, isHelp } = optionsOf(process.argv.slice(2));
if (isHelp) {
  console.log(USAGE);
  process.exit(0);
}
const accounts = PILOTS.map((username) => ({
  username,
  playerId: `pilot-${username}`,
  password: randomBytes(12).toString('base64url'),
}));

async function prepare() {
  const asked = [
    [ports.redis, { what: 'Redis', option: '--redis-port' }],
    [ports.gateway, { what: 'the gateway', option: '--gateway-port' }],
    [ports.page, { what: 'the page', option: '--page-port' }],
  ];
  for (const [port, whose] of asked) if (port !== undefined) await requireFree(port, whose);
  return createStack({
    appendfsync: 'everysec',
    ports,
    data,
    gatewayEnv: {
      TOUCHDOWN_SECRET: randomBytes(32).toString('base64url'),
      TOUCHDOWN_ACCOUNTS: JSON.stringify(accounts),
      TOUCHDOWN_HANGAR: JSON.stringify(HANGAR),
    },
  });
}

const stack = await prepare().catch((error) => stop(error.message));
const { folder } = stack;

let page = null;
async function end(code) {
  if (isEnding) return;
  isEnding = true;
  console.log('\nlive: stopping …');
  await page?.close();
  await stack.stop();
  console.log(`live: stopped; the Redis data is ${folder.isKept ? `in ${folder.path}` : 'removed'}`);
  process.exit(code);
}
// Also when the terminal is closed: the processes are in groups of their own and would keep running.
for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => end(0));

async function startStack() {
  for (const one of [stack.redis, stack.service, stack.gateway]) {
    if (isEnding) return;
    await one.start();
    keepUp(one);
    if (one === stack.redis) await setRate(stack.redisUrl, rate);
  }
}

async function startPage() {
  const server = {
    host: '127.0.0.1',
    ...(ports.page !== undefined && { port: ports.page, strictPort: true }),
  };
  page = await createServer({ server, logLevel: 'warn' });
  await page.listen();
  return page.resolvedUrls.local[0];
}

async function printAddresses(address) {
  const gateway = `127.0.0.1:${stack.gatewayPort}`;
  console.log(`\nlive: Redis ${stack.redisUrl}, gateway http://${gateway}, ${rate} Hz`);
  console.log(`live: Redis data in ${folder.path} (${folder.isKept ? 'kept' : 'removed at the end'})\n`);
  for (const { username, password } of accounts) {
    const token = await signIn(stack.gatewayPort, username, password);
    const server = `ws://${gateway}/stream?token=${token}`;
    console.log(`pilot ${username}: ${address}?server=${encodeURIComponent(server)}\n`);
  }
}

async function check(address) {
  await untilTicking(`http://127.0.0.1:${stack.gatewayPort}/healthz`);
  const html = await (await fetch(address)).text();
  if (!html.includes('<title>Touchdown</title>'))
    throw new Error(`the page at ${address} is not the playground`);
}

try {
  await startStack();
  const address = await startPage();
  await printAddresses(address);
  if (isCheck) {
    await check(address);
    await end(0);
  }
  console.log('Open each in its own window. Ctrl-C stops everything.');
} catch (error) {
  // A process that is being stopped fails to start.
  if (!isEnding) {
    console.error(`live: ${error.message}`);
    await end(1);
  }
}
