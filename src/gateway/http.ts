import type { IncomingMessage, ServerResponse } from 'node:http';
import type { Accounts } from './accounts';
import { type Bucket, consume, createBucket } from './clients/limits';

/** The parts of the gateway that the HTTP handler uses. */
export interface HttpContext {
  readonly accounts: Accounts;
  readonly isAllowedOrigin: (origin: string | undefined) => boolean;
  readonly shipOf: (playerId: string) => string;
  /** Status for operators. */
  readonly health: () => Readonly<Record<string, unknown>>;
  /** Wall s. */
  readonly now: () => number;
}

/** Maximum bytes of a request's body. */
const MAX_BODY = 4096;
/** Sign-in attempts from one address; slow enough to stop password guessing. */
const LOGINS = { perSecond: 0.5, burst: 10 };
/** Maximum addresses whose attempts are counted; at the limit all counts restart. */
const MAX_ADDRESSES = 10_000;

/** Handles the REST sign-in and the health check. */
export function createHttpHandler(
  context: HttpContext,
): (request: IncomingMessage, response: ServerResponse) => void {
  const logins = new Map<string, Bucket>();

  function mayLogin(address: string): boolean {
    if (logins.size > MAX_ADDRESSES) logins.clear();
    const bucket = logins.get(address) ?? createBucket(LOGINS, context.now());
    logins.set(address, bucket);
    return consume(bucket, 1, context.now());
  }

  async function login(request: IncomingMessage, response: ServerResponse): Promise<void> {
    if (!mayLogin(request.socket.remoteAddress ?? '')) {
      fail(response, 429, 'E008', 'Too many attempts; try again in a few seconds');
      return;
    }
    const { username, password } = await readFields(request);
    if (typeof username !== 'string' || typeof password !== 'string') {
      fail(response, 400, 'E001', 'username and password: expected strings');
      return;
    }
    const found = await context.accounts.login(username, password);
    if (found === null) {
      fail(response, 401, 'E005', 'Invalid username or password');
      return;
    }
    const { playerId } = found.player;
    answer(response, 200, {
      player_id: playerId,
      username,
      ship_id: context.shipOf(playerId),
      token: found.token,
      is_admin: false,
    });
  }

  return (request, response) => {
    const { origin } = request.headers;
    if (!context.isAllowedOrigin(origin)) {
      fail(response, 403, 'E003', 'Origin not allowed');
      return;
    }
    if (origin !== undefined) {
      response.setHeader('Access-Control-Allow-Origin', origin);
      response.setHeader('Access-Control-Allow-Headers', 'content-type');
      response.setHeader('Vary', 'Origin');
    }
    const route = `${request.method ?? ''} ${(request.url ?? '').split('?')[0]}`;
    if (request.method === 'OPTIONS') answer(response, 204, null);
    else if (route === 'GET /healthz') answer(response, 200, context.health());
    else if (route === 'POST /api/auth/login')
      login(request, response).catch(() =>
        fail(response, 400, 'E001', 'expected a JSON object of at most 4 kB'),
      );
    else fail(response, 404, 'E004', 'Not found');
  };
}

async function readFields(request: IncomingMessage): Promise<Record<string, unknown>> {
  const chunks: Buffer[] = [];
  let size = 0;
  for await (const chunk of request as AsyncIterable<Buffer>) {
    size += chunk.length;
    if (size > MAX_BODY) throw new RangeError('too large');
    chunks.push(chunk);
  }
  const fields: unknown = JSON.parse(Buffer.concat(chunks).toString());
  if (typeof fields !== 'object' || fields === null) throw new TypeError('not an object');
  return fields as Record<string, unknown>;
}

function fail(response: ServerResponse, status: number, code: string, message: string): void {
  answer(response, status, { error: { code, message } });
}

function answer(response: ServerResponse, status: number, body: unknown): void {
  if (response.headersSent) return;
  response.writeHead(status, { 'content-type': 'application/json' });
  response.end(body === null ? undefined : JSON.stringify(body));
}
