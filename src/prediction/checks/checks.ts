import type { Controls } from '../../dynamics';
import type { PartialFrame, ServerMessage } from '../../wire';
import type { Session } from '../session';
import { type Calls, createCalls, noteAdvance, noteFrame, noteTaken, noteUntaken, noteView } from './calls';
import { checkControls } from './records/controls';
import { checkKind, checkMessage } from './records/messages';
import { checkOptions } from './options';
import { checkTerrains } from './terrains';

/** Checks what a caller passes, and warns (ERRORS.md). Changes nothing; absent without a listener. */
export interface Checks {
  readonly receive: (message: ServerMessage | PartialFrame, now: number) => void;
  readonly advance: (controls: Controls | null, now: number) => void;
  readonly view: (now: number) => void;
  readonly taken: (call: string) => void;
}

/** The first frames are all checked; later ones are sampled, since most mistakes show from the start. */
const FIRST = 50;
const SAMPLED = 50;

/** The checks of one predictor, or null without a listener. */
export function createChecks(session: Session): Checks | null {
  const { warn, options } = session;
  if (options.onWarning === undefined) return null;
  checkOptions(warn, options);
  const calls = createCalls();
  return {
    receive: (message, now) => lookAtMessage(session, calls, message, now),
    advance(controls, now) {
      if (!Number.isFinite(now)) return;
      noteAdvance(warn, calls, now);
      if (calls.advances <= FIRST || calls.advances % SAMPLED === 0) checkControls(warn, controls);
      const { inputs } = session.sim;
      noteUntaken(warn, calls, inputs.records.length - inputs.unsent);
      if (controls !== null && session.receiver.ownShipId === '' && calls.frames > 0) {
        const message =
          'Controls are passed, but the player has no ship: set ownShipId, or pass null as a spectator.';
        warn('controls-without-ship', message, { controls });
      }
    },
    view: (now) => noteView(warn, calls, now),
    taken: (call) => noteTaken(warn, calls, call),
  };
}

function lookAtMessage(
  session: Session,
  calls: Calls,
  message: ServerMessage | PartialFrame,
  now: number,
): void {
  const { warn, config, receiver, sim } = session;
  if (!checkKind(warn, message)) return;
  if (message.kind === 'frame' && Number.isFinite(now)) {
    noteFrame(warn, calls, message, now, receiver.ownShipId);
    checkAcknowledgement(session, message);
    session.features.checkFeatures?.(session, message);
    if (calls.frames === FRAMES_BEFORE) checkTerrains(session);
  }
  if (calls.frames > FIRST && calls.frames % SAMPLED !== 0) return;
  // Their motion is known for the first frame's tick only.
  const bodies =
    sim.newestTick < 0 ? config.bodies : config.bodies.map((body) => ({ ...body, position: undefined }));
  checkMessage(warn, message, bodies);
}

/** Warns if the server acknowledges an input that this predictor has not made. */
function checkAcknowledgement({ warn, sim }: Session, { lastInput }: PartialFrame): void {
  const { nextSeq } = sim.inputs;
  if (lastInput === null || lastInput === undefined || nextSeq === 1 || !(lastInput.seq >= nextSeq)) return;
  const message = `Input ${lastInput.seq} is acknowledged, but only ${nextSeq - 1} were made here: two predictors on one connection, or a reloaded page without restore?`;
  warn('acknowledgement-foreign', message, { seq: lastInput.seq, made: nextSeq - 1 });
}

/** Frames by which a hello would have arrived. */
const FRAMES_BEFORE = 10;
