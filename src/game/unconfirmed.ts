/** The newest own controls, until the server certainly has them: a connection may be lost with messages under way. */
export interface UnconfirmedControls {
  /** The message with the newest controls, sent or not. */
  readonly commanded: (text: string) => void;
  /** A new connection: pings of the one before have no answer. */
  readonly opened: () => void;
  /** The player's ship, '' if the welcome does not name it. Controls given for another ship are forgotten. */
  readonly welcomed: (shipId: string) => void;
  /** A ping is being sent. */
  readonly pinged: () => void;
  /** A ping was answered: messages arrive in order, so everything sent before that ping has arrived. */
  readonly ponged: () => void;
  /** The message to send again on a new connection, or null. */
  readonly text: () => string | null;
}

interface Commanded {
  readonly text: string;
}

export function createUnconfirmedControls(): UnconfirmedControls {
  let newest: Commanded | null = null;
  let ship = '';
  /** The newest controls at each ping that has no answer yet, in order. */
  const pings: (Commanded | null)[] = [];
  return {
    commanded(text) {
      newest = { text };
    },
    opened() {
      pings.length = 0;
    },
    welcomed(shipId) {
      if (shipId !== '' && ship !== '' && shipId !== ship) newest = null;
      if (shipId !== '') ship = shipId;
    },
    pinged() {
      pings.push(newest);
    },
    ponged() {
      if (pings.shift() === newest) newest = null;
    },
    text: () => newest?.text ?? null,
  };
}
