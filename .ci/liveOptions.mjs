// Options of `npm run live -- …`.
import { parseArgs } from 'node:util';

export const USAGE = `npm run live -- [options]
  --rate HZ            ticks per second, 0.1 to 100 (default: 1, the game's own)
  --page-port PORT     of the page (default: 5173, or the next that is free)
  --gateway-port PORT  of the gateway (default: any that is free)
  --redis-port PORT    of Redis (default: any that is free)
  --data FOLDER        keeps the Redis data there, and continues from it (default: a temporary folder, removed at the end)
  --check              starts everything, checks that page and gateway answer, and ends
  --help               prints this`;

const OPTIONS = {
  rate: { type: 'string', default: '1' },
  'page-port': { type: 'string' },
  'gateway-port': { type: 'string' },
  'redis-port': { type: 'string' },
  data: { type: 'string' },
  check: { type: 'boolean', default: false },
  help: { type: 'boolean', default: false },
};

/** @throws Error that names the option and the expected value */
export function readOptions(args) {
  const { values } = parseArgs({ args, options: OPTIONS });
  const rate = Number(values.rate);
  if (!(rate >= 0.1 && rate <= 100)) throw new Error(`--rate: expected 0.1 to 100 Hz, got ${values.rate}`);
  const port = (name) => {
    const given = values[`${name}-port`];
    if (given === undefined) return undefined;
    const number = Number(given);
    if (!Number.isInteger(number) || number < 1 || number > 65535)
      throw new Error(`--${name}-port: expected 1 to 65535, got ${given}`);
    return number;
  };
  return {
    rate,
    data: values.data,
    isCheck: values.check,
    isHelp: values.help,
    ports: { page: port('page'), gateway: port('gateway'), redis: port('redis') },
  };
}
