// TCP ports of this machine.
import { createServer } from 'node:net';

function listenOn(port) {
  return new Promise((resolve, reject) => {
    const server = createServer();
    server.once('error', reject);
    server.listen(port, '127.0.0.1', () => {
      const { port: taken } = server.address();
      server.close(() => resolve(taken));
    });
  });
}

/** A port that is free now. */
export function freePort() {
  return listenOn(0);
}

/** @throws Error that names what the port is for and the option that chooses another, if the port is taken */
export async function requireFree(port, { what, option }) {
  await listenOn(port).catch((error) => {
    const cause = error.code === 'EADDRINUSE' ? 'is taken' : `cannot be used (${error.code})`;
    throw new Error(
      `port ${port} for ${what} ${cause}: choose another with ${option}, or leave it out for one that is free`,
    );
  });
}
