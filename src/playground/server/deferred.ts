import type { Connection } from './connection';

/** A connection whose code is fetched first. Messages sent before it is open are dropped, as with a closed one. */
export function deferConnection(loading: Promise<Connection>, failed: () => void): Connection {
  let inner: Connection | null = null;
  let isDisposed = false;
  loading.then((connection) => {
    if (isDisposed) connection.dispose();
    else inner = connection;
  }, failed);
  return {
    send: (message) => inner?.send(message),
    operate: (operation) => inner?.operate(operation),
    reconnect: () => inner?.reconnect(),
    setSpeed: (speed) => inner?.setSpeed(speed),
    dispose() {
      isDisposed = true;
      inner?.dispose();
    },
  };
}
