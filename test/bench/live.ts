/**
 * Capacity of the live stack on this machine: npm run bench:live [-- --json]
 * For 1 and 10 Hz and several fleets: whether the service held its rate, bytes of a state per client (JSON and protobuf),
 * p99 from a tick's due time to the client, CPU of service and gateway. All measured with a real Redis.
 */
import { readFileSync } from 'node:fs';
import { createClient } from 'redis';
import { WebSocket } from 'ws';
import { decodeServerMessage } from '../../src/wire';
import { type Operator, startOperator } from '../live/operator';

const CASES = [
  { rate: 1, ships: 100, clients: 50 },
  { rate: 1, ships: 500, clients: 50 },
  { rate: 1, ships: 2000, clients: 50 },
  { rate: 10, ships: 10, clients: 50 },
  { rate: 10, ships: 50, clients: 50 },
  { rate: 10, ships: 500, clients: 50 },
] as const;
/** Wall s of one measurement, after the fleet is there. */
const SECONDS = 10;
/** Clock ticks of /proc a second. */
const HERTZ = 100;
const SITE = [0.6, 0.48, 0.64] as const;

interface Heard {
  bytes: number;
  messages: number;
  readonly arrivals: { readonly tick: number; readonly at: number }[];
}

async function spawnFleet(redis: Redis, count: number): Promise<void> {
  for (let i = 0; i < count; i++) {
    const data = {
      ship_id: `fleet-${i}`,
      player_id: i === 0 ? 'pilot-one' : `nobody-${i}`,
      name: `fleet-${i}`,
      ship_class: 'planetary_lander',
      body: 'Luna',
      height: 3000,
      direction: [SITE[0] + (i % 50) * 1e-5, SITE[1], SITE[2] + Math.floor(i / 50) * 1e-5],
    };
    await redis.xAdd('touchdown:inbox', '*', { type: 'respawn', data: JSON.stringify(data) });
  }
}

type Redis = ReturnType<typeof connectTo>;

function connectTo(url: string) {
  return createClient({ url });
}

async function openClients(
  operator: Operator,
  count: number,
  heard: Record<'ws' | 'stream', Heard>,
): Promise<WebSocket[]> {
  const token = await operator.tokenOf('one');
  return Promise.all(
    Array.from({ length: count }, (_, i) => {
      const path = i % 2 === 0 ? 'ws' : 'stream';
      const socket = new WebSocket(`ws://127.0.0.1:${operator.stack.gatewayPort}/${path}`);
      socket.on('open', () => socket.send(JSON.stringify({ type: 'auth', token })));
      socket.on('message', (data: Buffer, isBinary) => hear(heard[path], data, isBinary));
      return new Promise<WebSocket>((resolve) => socket.once('message', () => resolve(socket)));
    }),
  );
}

function hear(heard: Heard, data: Buffer, isBinary: boolean): void {
  const at = Date.now() / 1000;
  heard.bytes += data.length;
  heard.messages += 1;
  if (!isBinary) {
    const tick = /^\{"type":"state","tick":(\d+)/.exec(data.subarray(0, 64).toString());
    if (tick !== null) heard.arrivals.push({ tick: Number(tick[1]), at });
    return;
  }
  // Only the tick is needed; decoding 50 whole frames is a cost of the benchmark, so one client in ten is timed.
  if (heard.messages % 10 !== 0) return;
  const message = decodeServerMessage(new Uint8Array(data));
  if (message.ok && message.value.kind === 'frame') heard.arrivals.push({ tick: message.value.tick, at });
}

/** CPU time that a process has used, s. */
function cpuOf(pid: number): number {
  const fields = readFileSync(`/proc/${pid}/stat`, 'utf8')
    .replace(/^.*\) /, '')
    .split(' ');
  return (Number(fields[11]) + Number(fields[12])) / HERTZ;
}

/** When the newest ticks were due, wall s by tick. Frames of a large fleet are megabytes: only what is needed is read of them. */
async function dueTimes(redis: Redis, rate: number): Promise<Map<number, number>> {
  const entries = await redis.xRevRange('touchdown:frames', '+', '-', { COUNT: 2 * rate });
  return new Map(
    (entries ?? []).map(({ message }) => {
      const due = /"due": ([\d.]+)/.exec(message['frame']!.slice(0, 1000))![1];
      return [Number(message['tick']), Number(due)];
    }),
  );
}

async function measure({
  rate,
  ships,
  clients,
}: (typeof CASES)[number]): Promise<Record<string, number | boolean>> {
  const operator = await startOperator('no');
  const redis = connectTo(operator.stack.redisUrl);
  await redis.connect();
  await operator.set('game:tick_rate', String(rate));
  await spawnFleet(redis, ships);
  const fresh = (): Heard => ({ bytes: 0, messages: 0, arrivals: [] });
  const heard = { ws: fresh(), stream: fresh() };
  const sockets = await openClients(operator, clients, heard);
  while ((await operator.frame()).ships.length < ships)
    await new Promise((resolve) => setTimeout(resolve, 100));
  Object.assign(heard, { ws: fresh(), stream: fresh() });
  const { service, gateway } = operator.stack;
  const statusOf = async () => {
    const { slipped, tick } = await redis.hGetAll('touchdown:status');
    return { slipped: Number(slipped), tick: Number(tick) };
  };
  const [before, serviceBefore, gatewayBefore] = [
    await statusOf(),
    cpuOf(service.pid()),
    cpuOf(gateway.pid()),
  ];
  const due = new Map<number, number>();
  const end = Date.now() + SECONDS * 1000;
  while (Date.now() < end) {
    await new Promise((resolve) => setTimeout(resolve, 1000));
    for (const [tick, at] of await dueTimes(redis, rate)) due.set(tick, at);
  }
  const [serviceCpu, gatewayCpu] = [
    cpuOf(service.pid()) - serviceBefore,
    cpuOf(gateway.pid()) - gatewayBefore,
  ];
  const after = await statusOf();
  const ticks = after.tick - before.tick;
  const late = [...heard.ws.arrivals, ...heard.stream.arrivals]
    .map(({ tick, at }) => at - (due.get(tick) ?? NaN))
    .filter((seconds) => !Number.isNaN(seconds))
    .sort((a, b) => a - b);
  const result = {
    rate,
    ships,
    clients,
    held: after.slipped === before.slipped && ticks >= SECONDS * rate - 1,
    json_bytes: Math.round(heard.ws.bytes / heard.ws.messages),
    protobuf_bytes: Math.round(heard.stream.bytes / heard.stream.messages),
    p99_tick_to_client_ms: Math.round((late[Math.floor(late.length * 0.99)] ?? NaN) * 1000),
    service_cpu_percent: Math.round((serviceCpu / SECONDS) * 100),
    gateway_cpu_percent: Math.round((gatewayCpu / SECONDS) * 100),
    service_cpu_percent_per_1000_ships: Math.round(((serviceCpu / ticks) * rate * 100 * 1000) / ships),
  };
  for (const socket of sockets) socket.terminate();
  redis.destroy();
  await operator.stop();
  return result;
}

const asJson = process.argv.includes('--json');
for (const one of CASES) {
  const result = await measure(one);
  if (asJson) console.log(JSON.stringify({ bench: 'live', ...result }));
  else
    console.log(
      Object.entries(result)
        .map(([name, value]) => `${name} ${String(value)}`)
        .join(' · '),
    );
}
