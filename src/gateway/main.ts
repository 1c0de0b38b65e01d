import { randomUUID } from 'node:crypto';
import { runProcess } from './process';

await runProcess(process, console, { clock: () => Date.now() / 1000, nonce: randomUUID });
