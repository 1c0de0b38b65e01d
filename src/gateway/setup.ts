import { err, ok, type Result } from '../dynamics';
import type { Account } from './accounts';
import type { GatewayOptions, Hangar } from './options';

type Given = Readonly<Record<string, string | undefined>>;

/**
 * A gateway's options from its environment:
 *   TOUCHDOWN_REDIS     redis://127.0.0.1:6379/0
 *   TOUCHDOWN_HOST, TOUCHDOWN_PORT   127.0.0.1, 8790
 *   TOUCHDOWN_SECRET    of the tokens, at least 32 characters; needed
 *   TOUCHDOWN_ACCOUNTS  JSON: [{"username", "playerId", "password"}, …]
 *   TOUCHDOWN_ORIGINS   comma-separated: pages that may connect beside those of this machine
 *   TOUCHDOWN_HANGAR    JSON: where players without a ship get one: {"body", "direction", "height", "ship_class", "delay"}
 */
export function loadSetup(
  given: Given,
  machine: Pick<GatewayOptions, 'clock' | 'nonce' | 'log'>,
): Result<GatewayOptions> {
  const secret = given['TOUCHDOWN_SECRET'] ?? '';
  if (secret.length < 32) return err('TOUCHDOWN_SECRET: expected at least 32 characters');
  const port = Number(given['TOUCHDOWN_PORT'] ?? 8790);
  if (!Number.isInteger(port) || port < 0 || port > 65535) return err('TOUCHDOWN_PORT: expected 0 to 65535');
  const accounts = readAccounts(given['TOUCHDOWN_ACCOUNTS'] ?? '[]');
  if (!accounts.ok) return accounts;
  const hangar = readHangar(given['TOUCHDOWN_HANGAR'], accounts.value);
  if (!hangar.ok) return hangar;
  return ok({
    redis: given['TOUCHDOWN_REDIS'] ?? 'redis://127.0.0.1:6379/0',
    host: given['TOUCHDOWN_HOST'] ?? '127.0.0.1',
    port,
    secret,
    tokenLifetime: 12 * 3600,
    accounts: accounts.value,
    origins: (given['TOUCHDOWN_ORIGINS'] ?? '').split(',').filter((origin) => origin !== ''),
    ...machine,
    ...(hangar.value !== null && { hangar: hangar.value }),
  });
}

function readAccounts(text: string): Result<Account[]> {
  const list = parsed(text);
  if (!Array.isArray(list)) return err('TOUCHDOWN_ACCOUNTS: expected a JSON list');
  for (const [i, account] of (list as Partial<Account>[]).entries()) {
    for (const field of ['username', 'playerId', 'password'] as const)
      if (typeof account[field] !== 'string' || account[field] === '')
        return err(`TOUCHDOWN_ACCOUNTS[${i}].${field}: expected a string`);
  }
  return ok(list as Account[]);
}

interface Berths {
  readonly body: string;
  readonly direction: readonly [number, number, number];
  readonly height: number;
  readonly ship_class: string;
  readonly delay: number;
}

/** Each player's ship stands 60 m east of the one before. */
const APART = 60;

function readHangar(text: string | undefined, accounts: readonly Account[]): Result<Hangar | null> {
  if (text === undefined) return ok(null);
  const given = parsed(text) as Partial<Berths> | null;
  if (typeof given !== 'object' || given === null || !Array.isArray(given.direction))
    return err('TOUCHDOWN_HANGAR: expected {"body", "direction", "height", "ship_class", "delay"}');
  const {
    body = '',
    direction = [0, 0, 1],
    height = 100,
    ship_class: shipClass = 'planetary_lander',
    delay = 5,
  } = given;
  const shipId = (playerId: string) => `ship-${playerId}`;
  return ok({
    shipId,
    delay,
    spawn(playerId, { frame }) {
      const ground = frame.bodies.find(({ name }) => name === body) ?? frame.bodies[0];
      if (ground === undefined) return null;
      const known = accounts.findIndex((account) => account.playerId === playerId);
      const berth = Math.max(0, known);
      return {
        ship_id: shipId(playerId),
        player_id: playerId,
        name: accounts[known]?.username ?? playerId,
        ship_class: shipClass,
        body: ground.name,
        direction: eastOf(direction, (berth * APART) / ground.radius),
        height,
      };
    },
  });
}

/** The direction, `angle` rad further east (small): east is the pole, body Y, × up. */
function eastOf([x, y, z]: Berths['direction'], angle: number): [number, number, number] {
  const length = Math.sqrt(x * x + z * z);
  return length === 0 ? [x, y, z] : [x + (z / length) * angle, y, z - (x / length) * angle];
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
