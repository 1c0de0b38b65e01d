import type { Session } from '../session';

/** Until `dispose`. */
export interface Lifetime {
  /** Whether a call is carried out; warns of one after `dispose`. */
  readonly carriesOut: (call: string) => boolean;
  readonly end: () => void;
}

export function createLifetime({ warn }: Session): Lifetime {
  let isDisposed = false;
  return {
    carriesOut(call) {
      if (!isDisposed) return true;
      warn('disposed', `${call} was called after dispose and does nothing: stop the frame loop first.`, {
        call,
      });
      return false;
    },
    end: () => (isDisposed = true),
  };
}
