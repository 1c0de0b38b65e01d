import {
  createPredictor,
  type Predictor,
  type PredictorOptions,
  type WorldView,
} from '../../../src/prediction';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createLink, type Link, type NetworkNumbers } from '../../../src/scenarios';
import type { Hello, InputRecord, PartialFrame, Pong } from '../../../src/wire';
import { frameAt, helloAt } from './restingShip';

/**
 * A server that only ticks, a network and a page, each of which can be stopped; all on one true time. The ship
 * is at rest, so that only time is tested. All times in seconds.
 */
export interface FaultyLine {
  predictor: Predictor;
  readonly tickRate: number;
  /** True time. */
  now: number;
  /** Server time by its own ticks: the ideal estimate. */
  readonly serverNow: () => number;
  /** The page's clock. */
  pageClock: (now: number) => number;
  /** Runs the page's frames for `seconds`. */
  readonly run: (seconds: number, each?: (view: WorldView) => void) => void;
  /** The page does not run for `seconds`; messages queue up. */
  readonly freezePage: (seconds: number) => void;
  /** Messages in these directions are held until the link resumes. */
  readonly holdLink: (seconds: number, ways: 'up' | 'down' | 'both') => void;
  /** The server does not tick for `seconds`, then continues at the same tick; it answers pings or not. */
  readonly pauseServer: (seconds: number, answers: boolean) => void;
  /** Ticks count from `tick` on. */
  readonly restartServer: (tick: number) => void;
  /** Server time of the newest frame that has reached the page. */
  newestFrame: number;
  /** The inputs sent, with the true server time when they were sent and when they arrive. */
  readonly inputs: SentInput[];
  controls: typeof NEUTRAL_CONTROLS;
}

export interface SentInput {
  readonly record: InputRecord;
  readonly sentAt: number;
}

export interface FaultyLineOptions {
  readonly network: NetworkNumbers;
  /** Hz */
  readonly tickRate: number;
  readonly seed: number;
  /** Ticks from one send to the next. */
  readonly sendEvery?: number;
  /** Drift: server seconds per true second, minus 1. */
  readonly drift?: number;
  readonly answersPings?: boolean;
  /** A server that sends a hello and applies inputs at their substep. */
  readonly hello?: boolean;
  /** Sees each answered ping, as a clock filter would: page time of ping and pong, and server time between. */
  readonly onPong?: (pinged: number, answered: number, now: number) => void;
  readonly predictor?: PredictorOptions;
}

const HZ = 60;
type Message = PartialFrame | Pong | Hello;

export function createFaultyLine(options: FaultyLineOptions): FaultyLine {
  const { network, tickRate, seed, sendEvery = 1, drift = 0, answersPings = true } = options;
  const rate = tickRate * (1 + drift);
  const down = createLink(network, seed);
  const up = createLink(network, seed + 1);
  const sent = new Map<number, Message | number>();
  const pingedAt = new Map<number, number>();
  let sequence = 0;
  let frames = 0;
  let tick = 0;
  let ticks = 0;
  let nextTick = 0;
  let tickedAt = 0;
  const held = { up: 0, down: 0, answers: 0 };

  function put(link: Link, message: Message | number, at: number): void {
    sequence += 1;
    sent.set(sequence, message);
    link.send(new Uint8Array(new Float64Array([sequence]).buffer), at);
  }

  function* arrived(
    link: Link,
    until: number,
    heldUntil: number,
  ): Generator<{ message: unknown; at: number }> {
    if (until < heldUntil) return;
    for (const { bytes, at } of link.deliver(until)) {
      const key = new Float64Array(bytes.buffer)[0]!;
      const message = sent.get(key);
      sent.delete(key);
      yield { message, at: Math.max(at, heldUntil) };
    }
  }

  function runServer(until: number): void {
    for (; nextTick <= until; nextTick += 1 / rate) {
      answer(nextTick);
      if (ticks > 0) tick += 1;
      ticks += 1;
      tickedAt = nextTick;
      if (tick % sendEvery === 0) put(down, frameAt(tick, tickRate), nextTick);
    }
    answer(until);
  }

  /** Pings that have arrived by `until`. */
  function answer(until: number): void {
    if (until < held.answers) return;
    for (const { message, at } of arrived(up, until, held.up)) {
      const answeredAt = Math.max(at, held.answers, tickedAt);
      const sinceTick = (answeredAt - tickedAt) * (1 + drift);
      if (answersPings) put(down, { kind: 'pong', id: message as number, tick, sinceTick }, answeredAt);
    }
  }

  const line: FaultyLine = {
    predictor: createPredictor({ ownShipId: 'ship-1', ...options.predictor }),
    tickRate,
    now: 0,
    pageClock: (now) => now,
    newestFrame: Number.NEGATIVE_INFINITY,
    inputs: [],
    controls: NEUTRAL_CONTROLS,
    serverNow: () => (tick + Math.min(1, (line.now - tickedAt) * rate)) / tickRate,
    run(seconds, each) {
      const until = line.now + seconds;
      while (line.now < until - 1e-9) {
        frames += 1;
        line.now = frames / HZ;
        runServer(line.now);
        const at = line.pageClock(line.now);
        for (const { message } of arrived(down, line.now, held.down)) hear(message as Message, at);
        line.predictor.advance(line.controls, at);
        for (const message of line.predictor.takeOutgoing()) {
          if (message.kind === 'ping') {
            pingedAt.set(message.id, at);
            put(up, message.id, line.now);
          } else for (const record of message.inputs) line.inputs.push({ record, sentAt: line.serverNow() });
        }
        each?.(line.predictor.view(at));
      }
    },
    freezePage(seconds) {
      frames += Math.round(seconds * HZ);
      line.now = frames / HZ;
      runServer(line.now);
    },
    holdLink(seconds, ways) {
      if (ways !== 'up') held.down = line.now + seconds;
      if (ways !== 'down') held.up = line.now + seconds;
    },
    pauseServer(seconds, answers) {
      nextTick += seconds;
      if (!answers) held.answers = line.now + seconds;
    },
    restartServer(first) {
      tick = first;
      ticks = 0;
      nextTick = line.now;
      line.newestFrame = Number.NEGATIVE_INFINITY;
      if (options.hello === true) put(down, helloAt(tick, tickRate), line.now);
    },
  };

  function hear(message: Message, at: number): void {
    if (message.kind === 'pong') {
      const answered = (message.tick + Math.min(1, message.sinceTick * tickRate)) / tickRate;
      options.onPong?.(pingedAt.get(message.id)!, answered, at);
      pingedAt.delete(message.id);
    }
    if (message.kind === 'frame') line.newestFrame = Math.max(line.newestFrame, message.tick / tickRate);
    line.predictor.receive(message, at);
  }

  if (options.hello === true) put(down, helloAt(0, tickRate), 0);
  return line;
}

/** Server time of a view. */
export function instantOf({ tick, sinceTick, tickRate, timeScale }: WorldView): number {
  return tick / tickRate + sinceTick / timeScale;
}
