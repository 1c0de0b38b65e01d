import { err, ok, type Result } from '../dynamics';
import { type Account, MIN_SECRET } from './accounts';
import type { GatewayOptions, Hangar } from './options';

const DEFAULT_PORT = 8790;
/** s: half a day. */
const TOKEN_LIFETIME = 12 * 3600;

type Environment = Readonly<Record<string, string | undefined>>;

/**
 * Reads a gateway's options from its environment:
 *   TOUCHDOWN_REDIS     redis://127.0.0.1:6379/0
 *   TOUCHDOWN_HOST, TOUCHDOWN_PORT   127.0.0.1, 8790
 *   TOUCHDOWN_SECRET    signs the tokens, at least 32 characters; required
 *   TOUCHDOWN_ACCOUNTS  JSON: [{"username", "playerId", "password"}, …]
 *   TOUCHDOWN_ORIGINS   comma-separated origins that may connect, besides localhost
 *   TOUCHDOWN_HANGAR    JSON: where ships are spawned for players without one: {"body", "direction", "height", "ship_class", "delay"}
 * @returns the options, or an error that names the invalid variable
 */
export function loadSetup(
  given: Environment,
  machine: Pick<GatewayOptions, 'clock' | 'nonce' | 'log'>,
): Result<GatewayOptions> {
  const secret = given['TOUCHDOWN_SECRET'] ?? '';
  if (secret.length < MIN_SECRET) return err(`TOUCHDOWN_SECRET: expected at least ${MIN_SECRET} characters`);
  const port = Number(given['TOUCHDOWN_PORT'] ?? DEFAULT_PORT);
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
    tokenLifetime: TOKEN_LIFETIME,
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

interface HangarConfig {
  readonly body: string;
  readonly direction: readonly [number, number, number];
  readonly height: number;
  readonly ship_class: string;
  readonly delay: number;
}

/** Distance between the slots of two players, m; slots lie in a row to the east. */
const SPACING = 60;

function readHangar(text: string | undefined, accounts: readonly Account[]): Result<Hangar | null> {
  if (text === undefined) return ok(null);
  const given = parsed(text) as Partial<HangarConfig> | null;
  if (typeof given !== 'object' || given === null || !Array.isArray(given.direction))
    return err('TOUCHDOWN_HANGAR: expected {"body", "direction", "height", "ship_class", "delay"}');
  const { body = '', height = 100, ship_class: shipClass = 'planetary_lander', delay = 5 } = given;
  const { direction } = given as HangarConfig;
  const shipId = (playerId: string) => `ship-${playerId}`;
  return ok({
    shipId,
    delay,
    spawn(playerId, { frame }) {
      const ground = frame.bodies.find(({ name }) => name === body) ?? frame.bodies[0];
      if (ground === undefined) return null;
      const known = accounts.findIndex((account) => account.playerId === playerId);
      const slot = Math.max(0, known);
      return {
        ship_id: shipId(playerId),
        player_id: playerId,
        name: accounts[known]?.username ?? playerId,
        ship_class: shipClass,
        body: ground.name,
        direction: eastOf(direction, (slot * SPACING) / ground.radius),
        height,
      };
    },
  });
}

/** `direction` (body axes, unnormalised) moved east by `angle` (rad, small); east is the pole, body Y, × up. */
function eastOf([x, y, z]: HangarConfig['direction'], angle: number): [number, number, number] {
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
