/** A static host as strict as the game's: the built page must work under this content security policy. */
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import type { Server, ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize, sep } from 'node:path';

/** No inline script or style, no eval, no data: or blob: addresses; sockets to any server. */
export const CONTENT_SECURITY_POLICY = "default-src 'self'; connect-src 'self' ws: wss:";

/** The page is not at the root of its host, so that an absolute address like "/models/x.glb" fails. */
const PREFIX = '/games/touchdown/';

const TYPES: Record<string, string> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
  '.glb': 'model/gltf-binary',
  '.wasm': 'application/wasm',
  '.woff2': 'font/woff2',
};

/** A host that misbehaves: answers a request itself and returns true, or leaves it to the folder. */
export type Fault = (file: string, response: ServerResponse) => boolean;

export interface StaticServer {
  /** The address of the served folder, ending with a slash. */
  readonly url: string;
  close(): Promise<void>;
}

/** The file in `folder` for a request's path, or null if there is none. */
export function fileFor(folder: string, pathname: string): string | null {
  if (!pathname.startsWith(PREFIX)) return null;
  const wished = pathname.slice(PREFIX.length);
  const path = normalize(join(folder, wished === '' ? 'index.html' : wished));
  if (!path.startsWith(normalize(folder) + sep)) return null;
  return statSync(path, { throwIfNoEntry: false })?.isFile() ? path : null;
}

function decodedPath(url: string): string {
  try {
    return decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch {
    return '';
  }
}

function fileServer(folder: string, fault: Fault): Server {
  return createServer((request, response) => {
    const pathname = decodedPath(request.url ?? '');
    if (fault(pathname.slice(PREFIX.length), response)) return;
    const path = fileFor(folder, pathname);
    const common = {
      'Content-Security-Policy': CONTENT_SECURITY_POLICY,
      'X-Content-Type-Options': 'nosniff',
      'Cache-Control': 'no-store',
    };
    if (path === null) {
      response.writeHead(404, { ...common, 'Content-Type': 'text/plain' }).end('not found');
      return;
    }
    const type = TYPES[extname(path)] ?? 'application/octet-stream';
    response.writeHead(200, { ...common, 'Content-Type': type });
    createReadStream(path).pipe(response);
  });
}

/** Serves `folder` on a free port of this machine. `fault` may change while it runs: it is read at each request. */
export async function serveFolder(folder: string, fault: Fault = () => false): Promise<StaticServer> {
  const server = fileServer(folder, fault);
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject).listen(0, '127.0.0.1', resolve);
  });
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}${PREFIX}`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
