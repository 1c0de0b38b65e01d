import { randomUUID } from 'node:crypto';
import { createGateway } from './index';
import { loadSetup } from './setup';

// The gateway's process. Its options come from the environment (setup.ts), so that no secret appears on a command line.

const setup = loadSetup(process.env, {
  clock: () => Date.now() / 1000,
  nonce: randomUUID,
  log: console.error,
});
if (!setup.ok) {
  console.error(`gateway: ${setup.reason}`);
  process.exit(2);
}
const gateway = await createGateway(setup.value);
console.log(`gateway: listening on http://${setup.value.host}:${gateway.port}`);

for (const signal of ['SIGINT', 'SIGTERM'] as const) {
  process.once(signal, () => {
    gateway.close().then(
      () => process.exit(0),
      () => process.exit(1),
    );
  });
}
