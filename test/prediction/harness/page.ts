import {
  type ClientMessage,
  type Controls,
  createPredictor,
  decodeFrameJson,
  type EventNotice,
  NEUTRAL_CONTROLS,
  type Predictor,
  type ServerMessage,
  type WorldView,
} from '../../../src/index';
import { encodeServerMessage, pendingServerMessage } from '../../../src/protobuf';
import type { Dice } from './random';
import { drawControls, OWN, type Setup } from './setup';
import { createWay, type Way } from './wire';

type Sent =
  | {
      readonly kind: 'frame';
      readonly json: string;
      readonly at: number;
      readonly tick: number;
      readonly era: number;
    }
  | { readonly kind: 'pong'; readonly id: number; readonly tick: number; readonly sinceTick: number };

/** A client's message, and whose controls it has. */
interface Upward {
  readonly message: ClientMessage;
  readonly shipId: string | null;
}

/** A browser page with its pilot, a network and the server, on one true time. */
export interface Page {
  readonly setup: Setup;
  readonly predictor: Predictor;
  readonly down: Way<Sent>;
  readonly up: Way<Upward>;
  readonly notices: EventNotice[];
  readonly warnings: Map<string, string>;
  readonly presses: Press[];
  /** True s. */
  t: number;
  /** What the page's clock is put on by, s. */
  shift: number;
  /** True time at which the newest frame that came in was sent. */
  newestAt: number;
  /** Its tick, and which of the server's runs it is of, from 1. */
  newestTick: number;
  newestEra: number;
  ownShip: string | null;
  hasPilot: boolean;
  /** Draws for `seconds`; `each` sees every display frame. */
  readonly run: (seconds: number, each?: (view: WorldView) => void) => void;
  /** Nothing runs in the page for `seconds`. */
  readonly freeze: (seconds: number) => void;
}

/** A change of controls: when it was made, when it showed in the view; true s. */
export interface Press {
  readonly at: number;
  readonly controls: Controls;
  drawnAt: number;
}

const DISPLAY = 60;

export function createPage(setup: Setup, dice: Dice): Page {
  const { server, told, clientTerrain } = setup;
  const warnings = new Map<string, string>();
  const notices: EventNotice[] = [];
  const predictor = createPredictor({
    ownShipId: OWN,
    terrains: { client: clientTerrain },
    defaults: { terrain: 'client', bodies: [told] },
    onWarning: (code, message) => warnings.set(code, message),
  });
  predictor.onEvent((notice) => notices.push({ ...notice }));
  const down = createWay<Sent>(setup.network, dice);
  const up = createWay<Upward>(setup.network, dice);
  let pilot = { controls: NEUTRAL_CONTROLS, until: 0 };
  let frames = 0;

  function runServer(t: number): void {
    const send = (frame: Record<string, unknown>, at: number) => {
      down.send(
        {
          kind: 'frame',
          json: JSON.stringify(frame),
          at,
          tick: frame['tick'] as number,
          era: server.eras.length,
        },
        at,
      );
    };
    for (const { message: sent, at } of up.take(t)) {
      server.runTo(at, send);
      const { message, shipId } = sent;
      if (message.kind === 'ping') {
        if (setup.answersPings) down.send({ kind: 'pong', id: message.id, ...server.clockAt(at) }, at);
      } else if (shipId !== null) {
        for (const { controls } of message.inputs) server.control(shipId, controls);
      }
    }
    server.runTo(t, send);
  }

  function hear(message: Sent, now: number): void {
    if (message.kind === 'pong') {
      predictor.receive(message, now);
      return;
    }
    if (message.at >= page.newestAt) [page.newestTick, page.newestEra] = [message.tick, message.era];
    page.newestAt = Math.max(page.newestAt, message.at);
    const decoded = decodeFrameJson(JSON.parse(message.json), { bodies: [told] });
    if (!decoded.ok) throw new Error(`the wire refused a frame of the design: ${decoded.reason}`);
    if (decoded.value.refusals.length > 0) throw new Error(decoded.value.refusals.join('; '));
    if (setup.door === 'json') predictor.receive(decoded.value, now);
    else {
      const whole = {
        paused: false,
        events: [],
        lastInput: null,
        ...decoded.value,
      } as unknown as ServerMessage;
      predictor.receivePending(pendingServerMessage(encodeServerMessage(whole)), now);
    }
  }

  function fly(): Controls | null {
    if (!page.hasPilot || page.ownShip === null) return null;
    if (page.t >= pilot.until) {
      const { controls, seconds } = drawControls(dice);
      pilot = { controls, until: page.t + seconds };
      page.presses.push({ at: page.t, controls, drawnAt: Number.NaN });
    }
    return pilot.controls;
  }

  const page: Page = {
    setup,
    predictor,
    down,
    up,
    notices,
    warnings,
    presses: [],
    t: 0,
    shift: 0,
    newestAt: 0,
    newestTick: 0,
    newestEra: 1,
    ownShip: OWN,
    hasPilot: true,
    run(seconds, each) {
      const until = page.t + seconds;
      while (page.t < until - 1e-9) {
        frames += 1;
        page.t = frames / DISPLAY;
        runServer(page.t);
        const now = clockOf(page);
        for (const { message } of down.take(page.t)) hear(message, now);
        predictor.advance(fly(), now);
        for (const message of predictor.takeOutgoing()) up.send({ message, shipId: page.ownShip }, page.t);
        const view = predictor.view(now);
        notePresses(page, view);
        each?.(view);
      }
    },
    freeze(seconds) {
      frames += Math.round(seconds * DISPLAY);
      page.t = frames / DISPLAY;
      runServer(page.t);
    },
  };
  return page;
}

/** What the page's clock reads, s. */
export function clockOf({ t, shift, setup }: Page): number {
  const now = t + shift;
  return setup.grain === 0 ? now : Math.floor(now / setup.grain + 1e-9) * setup.grain;
}

function notePresses({ presses, t }: Page, { own }: WorldView): void {
  for (let i = presses.length - 1; i >= 0 && own !== null; i--) {
    const press = presses[i]!;
    if (!Number.isNaN(press.drawnAt)) return;
    if (isSame(press.controls, own.controls)) press.drawnAt = t;
  }
}

function isSame(a: Controls, b: Controls): boolean {
  const near = (x: readonly number[], y: readonly number[]) =>
    x.every((value, k) => Math.abs(value - y[k]!) < 1e-9);
  return (
    Math.abs(a.thrustLevel - b.thrustLevel) < 1e-9 &&
    a.attitudeHold === b.attitudeHold &&
    near(a.rotationInput, b.rotationInput) &&
    near(a.translationInput, b.translationInput)
  );
}
