/**
 * The states of one link to the game's server, as plain data: `stepLink` takes a state and an event, and returns the
 * next state and the effects to carry out. Clock, random numbers and socket belong to the caller (GAME.md, Protocol).
 */

export type Phase = 'connecting' | 'authenticating' | 'live' | 'waiting' | 'refused' | 'ended';

/** Times are the caller's wall seconds; Infinity: nothing is due. */
export interface LinkState {
  readonly phase: Phase;
  /** Attempts that failed since the last welcome. */
  readonly failures: number;
  /** Whether there was a welcome before this attempt. */
  readonly wasLive: boolean;
  /** Live again, and no state has arrived yet. */
  readonly returned: boolean;
  /** No state for longer than usual, but the server answered a ping. */
  readonly silence: 'none' | 'asked' | 'answered';
  readonly welcomeBy: number;
  readonly pingAt: number;
  readonly pongBy: number;
  /** A state is expected before this. */
  readonly stateBy: number;
  readonly retryAt: number;
  /** In 'waiting' and 'refused': how the attempt ended. */
  readonly ended: Ending | null;
}

export interface Ending {
  readonly cause: 'unreachable' | 'lost' | 'noWelcome' | 'noPong' | 'auth' | 'origin';
  /** WebSocket close code; 0 where this side gave up. */
  readonly code: number;
  readonly reason: string;
}

export type LinkEvent =
  | { readonly kind: 'opened' }
  | { readonly kind: 'welcome' }
  /** A state arrived; usual seconds between two of them. */
  | { readonly kind: 'state'; readonly interval: number }
  | { readonly kind: 'pong' }
  | { readonly kind: 'closed'; readonly code: number; readonly reason: string }
  | { readonly kind: 'time' }
  /** The player requests another attempt at once. */
  | { readonly kind: 'retry' }
  | { readonly kind: 'end' };

/** 'open' includes closing the socket before; 'auth' sends the token. */
export type Effect = 'open' | 'auth' | 'ping' | 'close';

export interface Step {
  readonly state: LinkState;
  readonly effects: readonly Effect[];
}

const WELCOME_WITHIN = 10;
const PING_EACH = 30;
const PONG_WITHIN = 10;
/** No state for this long, and for three usual intervals, is silence, s. */
const SILENT_AFTER = 2;
const FIRST_RETRY = 1;
const LAST_RETRY = 30;

/** The game's own close codes. */
const CLOSED_AUTH = 4001;
const CLOSED_ORIGIN = 4003;

const NOTHING_DUE = {
  welcomeBy: Infinity,
  pingAt: Infinity,
  pongBy: Infinity,
  stateBy: Infinity,
  retryAt: Infinity,
  silence: 'none',
  returned: false,
} as const;

/**
 * The first attempt, at `now`.
 *
 * @example
 * ```ts
 * const { state, effects } = beginLink(now);
 * console.log(state.phase, effects); // 'connecting', the caller's next actions
 * ```
 */
export function beginLink(now: number): Step {
  return connect({ phase: 'connecting', failures: 0, wasLive: false, ended: null, ...NOTHING_DUE }, now);
}

/**
 * @param now wall s, not before the last step's
 * @param jitter 0 to 1, drawn for each step
 *
 * @example
 * ```ts
 * const first = beginLink(now);
 * const { state } = stepLink(first.state, { kind: 'opened' }, now, Math.random());
 * console.log(state.phase); // 'authenticating'
 * ```
 */
export function stepLink(state: LinkState, event: LinkEvent, now: number, jitter: number): Step {
  switch (event.kind) {
    case 'opened':
      return state.phase === 'connecting'
        ? { state: { ...state, phase: 'authenticating', welcomeBy: now + WELCOME_WITHIN }, effects: ['auth'] }
        : stay(state);
    case 'welcome':
      return state.phase === 'authenticating' ? welcomed(state, now) : stay(state);
    case 'state':
      return state.phase === 'live' ? stay(receiveState(state, now, event.interval)) : stay(state);
    case 'pong':
      return stay({
        ...state,
        pongBy: Infinity,
        silence: state.silence === 'asked' ? 'answered' : state.silence,
      });
    case 'closed':
      return closed(state, event, now, jitter);
    case 'retry':
      return state.phase === 'waiting' || state.phase === 'refused' ? connect(state, now) : stay(state);
    case 'end':
      return { state: { ...state, ...NOTHING_DUE, phase: 'ended' }, effects: ['close'] };
    case 'time':
      return onTime(state, now, jitter);
  }
}

/** When `stepLink` must be called next, wall s; Infinity: only on an event. */
export function dueAt(state: LinkState): number {
  return Math.min(state.welcomeBy, state.pingAt, state.pongBy, state.stateBy, state.retryAt);
}

function stay(state: LinkState): Step {
  return { state, effects: [] };
}

function connect(state: LinkState, now: number): Step {
  // A socket that never opens is treated like a welcome that never comes.
  const next = { ...state, ...NOTHING_DUE, phase: 'connecting', welcomeBy: now + WELCOME_WITHIN } as const;
  return { state: next, effects: ['open'] };
}

function welcomed(state: LinkState, now: number): Step {
  const live = { phase: 'live', failures: 0, wasLive: true, ended: null, pingAt: now + PING_EACH } as const;
  const due = { ...NOTHING_DUE, ...live, returned: state.wasLive, stateBy: now + SILENT_AFTER };
  return stay(due);
}

function receiveState(state: LinkState, now: number, interval: number): LinkState {
  const stateBy = now + Math.max(SILENT_AFTER, 3 * interval);
  return { ...state, stateBy, silence: 'none', returned: false };
}

function closed(state: LinkState, event: LinkEvent & { kind: 'closed' }, now: number, jitter: number): Step {
  const { code, reason } = event;
  if (state.phase === 'waiting' || state.phase === 'refused' || state.phase === 'ended') return stay(state);
  if (code === CLOSED_AUTH || code === CLOSED_ORIGIN) {
    const cause = code === CLOSED_AUTH ? 'auth' : 'origin';
    const refused = { phase: 'refused', ended: { cause, code, reason } } as const;
    return { state: { ...state, ...NOTHING_DUE, ...refused }, effects: ['close'] };
  }
  const cause = state.phase === 'connecting' ? 'unreachable' : 'lost';
  return giveUp(state, { cause, code, reason }, now, jitter);
}

/**
 * Another attempt after a wait that doubles with each failure, with a quarter of jitter either way, so that clients do not reconnect all
 * at once.
 */
function giveUp(state: LinkState, ended: Ending, now: number, jitter: number): Step {
  const wait = Math.min(LAST_RETRY, FIRST_RETRY * 2 ** state.failures) * (0.75 + 0.5 * jitter);
  const waiting = { phase: 'waiting', failures: state.failures + 1, ended, retryAt: now + wait } as const;
  return { state: { ...state, ...NOTHING_DUE, ...waiting }, effects: ['close'] };
}

function onTime(state: LinkState, now: number, jitter: number): Step {
  if (now >= state.retryAt) return connect(state, now);
  if (now >= state.welcomeBy) {
    const cause = state.phase === 'connecting' ? 'unreachable' : 'noWelcome';
    return giveUp(state, { cause, code: 0, reason: '' }, now, jitter);
  }
  if (now >= state.pongBy) return giveUp(state, { cause: 'noPong', code: 0, reason: '' }, now, jitter);
  if (now >= state.stateBy) {
    const asked = { ...state, stateBy: Infinity, silence: 'asked' } as const;
    return { state: pinged(asked, now), effects: ['ping'] };
  }
  if (now >= state.pingAt) return { state: pinged(state, now), effects: ['ping'] };
  return stay(state);
}

function pinged(state: LinkState, now: number): LinkState {
  return { ...state, pingAt: now + PING_EACH, pongBy: Math.min(state.pongBy, now + PONG_WITHIN) };
}
