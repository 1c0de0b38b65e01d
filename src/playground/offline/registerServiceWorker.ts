import { scriptUrl } from '../scriptUrl';

/**
 * Lets the browser store the page for use without a network, including plots, once it is idle. If it cannot (a host
 * without https, a private window, the development server, which has no offline.js) the page works as it is, while it is open.
 * @param stored called when the page can be reloaded without a network
 */
export function registerServiceWorker(window: Window, stored: () => void): void {
  if (!import.meta.env.PROD || !('serviceWorker' in window.navigator)) return;
  const start = () => {
    register(window, stored).catch(() => undefined);
  };
  if ('requestIdleCallback' in window) window.requestIdleCallback(start, { timeout: LATEST });
  else setTimeout(start, LATEST);
}

/** ms: a slow machine is never idle. */
const LATEST = 5000;
async function register(window: Window, stored: () => void): Promise<void> {
  const { serviceWorker } = window.navigator;
  const address = new URL('.', window.document.baseURI).href;
  const script = new URL('offline.js', address);
  await serviceWorker.register(scriptUrl(script.href));
  await serviceWorker.ready;
  stored();
}
