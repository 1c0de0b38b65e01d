/**
 * Has the browser keep the page for use without a network, plots too, once it has nothing better to do. Where it cannot (a host
 * without https, a private window, the development server, which has no offline.js) the page works as it is, while it is open.
 * @param kept called when a reload without a network works
 */
export function keepForOffline(window: Window, kept: () => void): void {
  if (!import.meta.env.PROD || !('serviceWorker' in window.navigator)) return;
  const register = async () => {
    const { serviceWorker } = window.navigator;
    const controlled = new Promise((resolve) => {
      if (serviceWorker.controller !== null) resolve(null);
      else serviceWorker.addEventListener('controllerchange', resolve, { once: true });
    });
    await serviceWorker.register(new URL('offline.js', window.document.baseURI));
    await serviceWorker.ready;
    await controlled;
    kept();
  };
  const start = () => {
    register().catch(() => undefined);
  };
  if ('requestIdleCallback' in window) window.requestIdleCallback(start, { timeout: LATEST });
  else setTimeout(start, LATEST);
}

/** ms: a slow machine is never idle. */
const LATEST = 5000;
