import type { ToServer } from './server/connection';

// One program for page and worker: what both need is fetched once.
if (typeof document === 'undefined') {
  const early: MessageEvent<ToServer>[] = [];
  self.onmessage = (event: MessageEvent<ToServer>) => early.push(event);
  void import('./server/worker').then(({ serve }) => serve(early));
} else {
  void import('./page').then(({ begin }) => begin(document, import.meta.url));
}
