/** Heap of a page and of its workers by the browser's debugging protocol, after a forced collection. */
import type { CDPSession, Page } from 'playwright-core';

/** MB, including typed arrays. `frames` since the page was opened. */
export interface HeapReading {
  readonly page: number;
  readonly workers: number;
  readonly frames: number;
}

export interface HeapReader {
  readonly read: () => Promise<HeapReading>;
}

interface HeapUsage {
  readonly usedSize: number;
  readonly embedderHeapUsedSize?: number;
  readonly backingStorageSize?: number;
}

const MB = 1_000_000;

function megabytes({ usedSize, embedderHeapUsedSize = 0, backingStorageSize = 0 }: HeapUsage): number {
  return (usedSize + embedderHeapUsedSize + backingStorageSize) / MB;
}

type Send = (method: string) => Promise<unknown>;

async function usageAfterCollection(send: Send): Promise<number> {
  // The second collection frees what finalisers have released.
  for (let n = 0; n < 2; n++) await send('HeapProfiler.collectGarbage');
  return megabytes((await send('Runtime.getHeapUsage')) as HeapUsage);
}

/** Create it before the page loads: workers are found when they start. */
export async function createHeapReader(session: CDPSession, page: Page): Promise<HeapReader> {
  const workers = await attachWorkers(session);
  await page.addInitScript(() => {
    const counted = window as Window & { framesSoFar?: number };
    counted.framesSoFar = 0;
    const count = () => {
      counted.framesSoFar! += 1;
      requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
  });
  return {
    async read() {
      let sum = 0;
      for (const send of workers.values()) sum += await usageAfterCollection(send);
      return {
        page: await usageAfterCollection((method) => session.send(method as 'Runtime.getHeapUsage')),
        workers: sum,
        frames: await page.evaluate(() => (window as Window & { framesSoFar?: number }).framesSoFar ?? 0),
      };
    },
  };
}

/** A send function for each dedicated worker, by its session. */
async function attachWorkers(session: CDPSession): Promise<ReadonlyMap<string, Send>> {
  const workers = new Map<string, Send>();
  const answers = new Map<number, (result: unknown) => void>();
  let last = 0;
  session.on('Target.attachedToTarget', ({ sessionId, targetInfo }) => {
    if (targetInfo.type !== 'worker') return;
    workers.set(sessionId, async (method) => {
      const id = ++last;
      const answer = new Promise((resolve) => answers.set(id, resolve));
      await session.send('Target.sendMessageToTarget', {
        sessionId,
        message: JSON.stringify({ id, method }),
      });
      return answer;
    });
  });
  session.on('Target.detachedFromTarget', ({ sessionId }) => workers.delete(sessionId));
  session.on('Target.receivedMessageFromTarget', ({ message }) => {
    const { id, result } = JSON.parse(message) as { id?: number; result?: unknown };
    if (id === undefined) return;
    answers.get(id)?.(result);
    answers.delete(id);
  });
  await session.send('Target.setAutoAttach', {
    autoAttach: true,
    waitForDebuggerOnStart: false,
    flatten: false,
  });
  return workers;
}
