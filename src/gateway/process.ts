import { createGateway } from './gateway';
import type { GatewayOptions } from './options';
import { loadSetup } from './setup';

/**
 * Runs a gateway until SIGINT or SIGTERM. Its options come from the environment (setup.ts), so that no secret appears on a command line.
 */
export async function runProcess(
  host: Pick<NodeJS.Process, 'env' | 'exit' | 'once'>,
  { log, error }: Pick<Console, 'log' | 'error'>,
  machine: Pick<GatewayOptions, 'clock' | 'nonce'>,
): Promise<void> {
  const setup = loadSetup(host.env, { ...machine, log: error });
  if (!setup.ok) {
    error(`gateway: ${setup.reason}`);
    host.exit(2);
    return;
  }
  const gateway = await createGateway(setup.value);
  log(`gateway: listening on http://${setup.value.host}:${gateway.port}`);
  for (const signal of ['SIGINT', 'SIGTERM'] as const) {
    host.once(signal, () => {
      gateway.close().then(
        () => host.exit(0),
        () => host.exit(1),
      );
    });
  }
}
