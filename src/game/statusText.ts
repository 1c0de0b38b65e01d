import type { Ending, LinkState, Phase } from './link';

/** A link's status as text for the player. */
export interface LinkStatus {
  readonly phase: Phase;
  /** A sentence or two; empty while all is well. */
  readonly text: string;
}

/**
 * @param address as entered, without a token
 * @param now wall s
 *
 * @example
 * ```ts
 * const { text } = statusOf(beginLink(now).state, 'game.example', now);
 * console.log(text);
 * ```
 */
export function statusOf(state: LinkState, address: string, now: number): LinkStatus {
  return { phase: state.phase, text: textOf(state, address, now) };
}

function textOf(state: LinkState, address: string, now: number): string {
  switch (state.phase) {
    case 'connecting':
      return state.failures > 0 || state.wasLive
        ? `Reconnecting to ${address}…`
        : `Connecting to ${address}…`;
    case 'authenticating':
      return `Connected to ${address}; signing in…`;
    case 'live':
      return liveText(state, address);
    case 'waiting': {
      const seconds = Math.max(0, Math.ceil(state.retryAt - now));
      return `${endingText(state.ended, address)} Retrying in ${seconds} s.`;
    }
    case 'refused':
      return endingText(state.ended, address);
    case 'ended':
      return 'Disconnected.';
  }
}

function liveText({ silence, returned }: LinkState, address: string): string {
  if (silence === 'answered') return 'The server answers but sends no states: the game is paused.';
  if (silence === 'asked') return 'No states from the server; pinging it…';
  return returned ? `Connected to ${address} again.` : '';
}

function endingText(ended: Ending | null, address: string): string {
  const said = ended === null || ended.reason === '' ? '' : `, “${ended.reason}”`;
  const code = ended === null || ended.code === 0 ? '' : ` (code ${ended.code}${said})`;
  switch (ended?.cause) {
    case undefined:
    case 'lost':
      return `The connection to ${address} was lost${code}.`;
    case 'unreachable':
      return `Nothing answers at ${address}${code}. Is the server running?`;
    case 'noWelcome':
      return `${address} accepted the connection but sent no welcome within 10 s.`;
    case 'noPong':
      return `${address} did not answer a ping within 10 s.`;
    case 'auth':
      return `${address} refused the sign-in${code}: the token is missing, invalid or expired. Sign in again.`;
    case 'origin':
      return `${address} does not accept pages from here${code}: open the page from an allowed origin.`;
  }
}
