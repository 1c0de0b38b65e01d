import type { ToServer } from './server/connection';

// One program for page and worker, so that shared code is loaded once.
if (typeof document === 'undefined') {
  const early: MessageEvent<ToServer>[] = [];
  self.onmessage = (event: MessageEvent<ToServer>) => early.push(event);
  // Reported, so that the page receives it as the worker's error.
  void import('./server/worker').then(
    ({ serve }) => serve(early),
    () => reportError(new Error('its program could not be fetched')),
  );
} else {
  void import('./page').then(
    ({ begin }) => begin(document, import.meta.url),
    () => {
      document.getElementById('banner')!.textContent =
        'Part of the page did not load. Check the network and reload.';
    },
  );
}
