import { afterEach, beforeEach, expect, vi } from 'vitest';
import { createLive, type Live } from '../../../src/playground/game/live/live';
import { type Choices, DEFAULT_CHOICES } from '../../../src/playground/panels/choices';
import type { FromServer, ToServer } from '../../../src/playground/server/connection';
import { serve } from '../../../src/playground/server/worker';
import type { WorldView } from '../../../src/prediction';
import { normalNoise, createRandom, type RecordingEntry, type RunInput } from '../../../src/scenarios';

/** The real page and worker on one virtual clock; they exchange only messages, as in a browser. */
export interface Game {
  readonly live: Live;
  readonly entries: readonly RecordingEntry[];
  /** The bytes of those that are recorded as they were sent. */
  readonly sent: ReadonlyMap<RecordingEntry, Uint8Array>;
  /** Inputs of a run, as reported by the server. */
  readonly runs: (readonly RunInput[])[];
  /** Draws at about `fps` frames a second until `seconds` have passed, `each` after every frame. */
  readonly play: (fps: number, seconds: number, each?: (view: WorldView) => void) => void;
}

interface Scope {
  onmessage: (event: { data: ToServer }) => void;
  postMessage: (message: FromServer, options: { transfer: Transferable[] }) => void;
}

/** Fake timers and stubs for the tests of a file. */
export function useGameClock(): void {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });
}

/** Starts the built-in server whenever the page asks for its worker. */
export function serveInNode(): void {
  const scope = { onmessage: () => undefined, postMessage: () => undefined } as Scope;
  vi.stubGlobal('self', scope);
  vi.stubGlobal(
    'Worker',
    class {
      onmessage = (_event: { data: FromServer }) => undefined;
      constructor() {
        scope.postMessage = (message, { transfer }) => {
          const data = structuredClone(message, { transfer });
          setTimeout(() => this.onmessage({ data }));
        };
      }
      postMessage(message: ToServer) {
        const data = structuredClone(message);
        setTimeout(() => scope.onmessage({ data }));
      }
      terminate() {
        scope.onmessage = () => undefined;
      }
    },
  );
  serve([]);
}

export function open(asked: Partial<Choices>): Game {
  serveInNode();
  const entries: RecordingEntry[] = [];
  const sent = new Map<RecordingEntry, Uint8Array>();
  const runs: (readonly RunInput[])[] = [];
  const live = createLive('main.js', {
    onState: () => undefined,
    onWorld: () => entries.splice(0),
    onRefused: (reason) => expect.unreachable(reason),
    onEvent: () => undefined,
    onEntry(entry, bytes) {
      entries.push(entry);
      if (bytes !== undefined) sent.set(entry, bytes);
    },
    onLost: () => undefined,
    onRun: (inputs) => runs.push(inputs),
    onScenario: () => undefined,
  });
  live.begin({ ...DEFAULT_CHOICES, ...asked });
  const rng = createRandom(11);
  return {
    live,
    entries,
    sent,
    runs,
    play(fps, seconds, each) {
      for (let passed = 0; passed < seconds * 1000;) {
        // Frame times are irregular: off by a fifth, and one in fifty is five times as late.
        const late = rng() < 0.02 ? 5 : 1;
        const wait = Math.max(1, (1000 / fps) * late * (1 + normalNoise(rng) / 5));
        passed += wait;
        vi.advanceTimersByTime(wait);
        each?.(live.frame());
        if (each === undefined) live.frame();
      }
    },
  };
}
