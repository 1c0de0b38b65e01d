// The whole game on this machine: Redis, physics service, gateway and page, for two pilots.
//   npm run live                     at 1 Hz, the game's own rate
//   npm run live -- --rate 10        at another
//   npm run live -- --check          starts it all, looks that page and gateway answer, and ends
// Ends with Ctrl-C. What dies meanwhile is started again, and the pilots fly on.
import { randomBytes } from 'node:crypto';
import { createClient } from 'redis';
import { createServer } from 'vite';
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
/** ms before what has died is started again. */
const AGAIN = 500;

function stop(message) {
  console.error(`live: ${message}`);
  process.exit(1);
}

function rateOf(args) {
  const at = args.indexOf('--rate');
  const rate = at < 0 ? 1 : Number(args[at + 1]);
  if (!(rate >= 0.1 && rate <= 100)) stop('--rate: expected 0.1 to 100 Hz');
  return rate;
}

/** Starts it again whenever it dies by itself. */
function keepUp(process) {
  process.whenItDies((how) => {
    console.log(`live: ${process.name} ended (${how}); starting it again …`);
    setTimeout(() => process.start().catch((error) => console.error(`live: ${error.message}`)), AGAIN);
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

/** Until the gateway has seen a tick of the service. @throws after half a minute */
async function untilTicking(url) {
  const until = Date.now() + 30_000;
  while (Date.now() < until) {
    if ((await (await fetch(url)).json()).tick !== null) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`no tick within 30 s, says ${url}`);
}

const rate = rateOf(process.argv.slice(2));
const accounts = PILOTS.map((username) => ({
  username,
  playerId: `pilot-${username}`,
  password: randomBytes(12).toString('base64url'),
}));
const stack = await createStack({
  appendfsync: 'everysec',
  gatewayEnv: {
    TOUCHDOWN_SECRET: randomBytes(32).toString('base64url'),
    TOUCHDOWN_ACCOUNTS: JSON.stringify(accounts),
    TOUCHDOWN_HANGAR: JSON.stringify(HANGAR),
  },
}).catch((error) => stop(error.message));

let page = null;
let isEnding = false;
async function end() {
  if (isEnding) return;
  isEnding = true;
  console.log('\nlive: stopping …');
  await page?.close();
  await stack.stop();
  process.exit(0);
}
process.on('SIGINT', end);
process.on('SIGTERM', end);

try {
  for (const one of [stack.redis, stack.service, stack.gateway]) {
    await one.start();
    keepUp(one);
    if (one === stack.redis) await setRate(stack.redisUrl, rate);
  }
  page = await createServer({ server: { host: '127.0.0.1' }, logLevel: 'warn' });
  await page.listen();
  const [address] = page.resolvedUrls.local;
  console.log(`\nlive: Redis ${stack.redisUrl}, gateway http://127.0.0.1:${stack.gatewayPort}, ${rate} Hz\n`);
  for (const { username, password } of accounts) {
    const token = await signIn(stack.gatewayPort, username, password);
    const server = `ws://127.0.0.1:${stack.gatewayPort}/stream?token=${token}`;
    console.log(`pilot ${username}: ${address}?server=${encodeURIComponent(server)}\n`);
  }
  if (process.argv.includes('--check')) {
    await untilTicking(`http://127.0.0.1:${stack.gatewayPort}/healthz`);
    const html = await (await fetch(address)).text();
    if (!html.includes('<title>Touchdown</title>'))
      throw new Error(`the page at ${address} is not the playground`);
    await end();
  }
  console.log('Open each in a window of its own. Ctrl-C ends it all.');
} catch (error) {
  if (!isEnding) {
    console.error(`live: ${error.message}`);
    await stack.stop();
    process.exit(1);
  }
}
