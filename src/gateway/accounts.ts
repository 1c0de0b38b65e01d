import { randomBytes, scrypt, timingSafeEqual } from 'node:crypto';
import { promisify } from 'node:util';
import { jwtVerify, SignJWT } from 'jose';

/** The identity in a token. */
export interface Player {
  readonly playerId: string;
  readonly username: string;
  /** Expiry of the token, wall s since 1970. */
  readonly expires: number;
}

/** Accounts and their tokens. Passwords are stored as scrypt hashes. */
export interface Accounts {
  /** A token, or null if name or password is wrong. Unknown names take as long as wrong passwords. */
  readonly login: (username: string, password: string) => Promise<{ player: Player; token: string } | null>;
  readonly verify: (token: string) => Promise<Player | null>;
  readonly renew: (player: Player) => Promise<string>;
}

export interface Account {
  readonly playerId: string;
  readonly username: string;
  readonly password: string;
}

const hash = promisify<string, Buffer, number, Buffer>(scrypt);
const ISSUER = 'touchdown';
const CHECKS = { issuer: ISSUER, algorithms: ['HS256'], requiredClaims: ['sub', 'exp'] };
/** Bytes of a password hash. */
const HASH_LENGTH = 32;
/** Minimum characters of a secret. */
export const MIN_SECRET = 32;

/**
 * @param secret at least MIN_SECRET characters, shared by all gateways of a game
 * @param lifetime s
 * @param now wall s since 1970
 */
export async function createAccounts(
  accounts: readonly Account[],
  { secret, lifetime, now }: { secret: string; lifetime: number; now: () => number },
): Promise<Accounts> {
  if (secret.length < MIN_SECRET) throw new RangeError(`secret: expected at least ${MIN_SECRET} characters`);
  const key = new TextEncoder().encode(secret);
  const stored = new Map<string, { playerId: string; salt: Buffer; digest: Buffer }>();
  for (const { username, playerId, password } of accounts) {
    const salt = randomBytes(16);
    stored.set(username, { playerId, salt, digest: await hash(password, salt, HASH_LENGTH) });
  }
  const unknown = { playerId: '', salt: randomBytes(16), digest: randomBytes(HASH_LENGTH) };

  const sign = (player: Omit<Player, 'expires'>, expires: number) =>
    new SignJWT({ username: player.username })
      .setProtectedHeader({ alg: 'HS256' })
      .setIssuer(ISSUER)
      .setSubject(player.playerId)
      .setIssuedAt(Math.floor(now()))
      .setExpirationTime(expires)
      .sign(key);

  return {
    async login(username, password) {
      const account = stored.get(username) ?? unknown;
      const digest = await hash(password, account.salt, HASH_LENGTH);
      if (!timingSafeEqual(digest, account.digest) || account === unknown) return null;
      const expires = Math.floor(now() + lifetime);
      const player = { playerId: account.playerId, username, expires };
      return { player, token: await sign(player, expires) };
    },
    async verify(token) {
      try {
        const { payload } = await jwtVerify(token, key, CHECKS);
        const { sub, aud, username }: Record<string, unknown> = payload;
        // Tokens of this gateway have no audience: one that names an audience is for another service.
        if (typeof sub !== 'string' || sub === '' || aud !== undefined) return null;
        const expires = payload.exp ?? 0;
        return { playerId: sub, username: typeof username === 'string' ? username : '', expires };
      } catch {
        return null;
      }
    },
    renew: (player) => sign(player, Math.floor(now() + lifetime)),
  };
}
