import { afterAll, beforeAll, expect, it } from 'vitest';
import { type DelayProxy, startDelayProxy } from './delayProxy';
import { type Operator, startOperator } from './operator';
import { type LivePilot, startPilot } from './pilot';

/** One way, s. */
const DELAY = 0.05;
/** s; offsets are within 5 % after 0.3 (PREDICTION, Drawing). */
const EASED = 1;

let operator: Operator;
let proxy: DelayProxy;

beforeAll(async () => {
  operator = await startOperator('no');
  proxy = await startDelayProxy(operator.stack.gatewayPort, DELAY);
});
afterAll(async () => {
  await proxy.close();
  await operator.stop();
});

/** A drop of `pilot`'s ship, watched until it has landed. */
async function watchDrop(pilot: LivePilot, name: string, look: () => void): Promise<void> {
  const before = (await operator.frame()).tick;
  await operator.drop(name, 40, 8);
  const isFalling = () =>
    pilot
      .frames()
      .some(
        ({ tick, ships }) =>
          tick > before &&
          ships.some(
            ({ shipId, surfaceContactState }) => shipId === `ship-${name}` && surfaceContactState === '',
          ),
      );
  let isDown = false;
  let since = NaN;
  await pilot.fly((view, now) => {
    const own = view.own;
    if (own === null || !isFalling()) return false;
    if (Number.isNaN(since)) since = now;
    // The jump to the new place is eased for a moment: no part of the bounce.
    if (now - since < EASED) return false;
    look();
    isDown ||= own.surfaceContactState === 'contact';
    return isDown && own.shownState === 'landed' && own.provenance === 'confirmed';
  });
}

it.each([1, 10])(
  'a coasting bounce at %i Hz agrees with the service on /stream, with no correction',
  async (rate) => {
    await operator.set('game:tick_rate', String(rate));
    await operator.drop('one', 5, 0.1);
    const pilot = startPilot(await operator.addressOf('one', 'stream', proxy.port));
    await pilot.fly((view) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed');
    pilot.predictor.teleported('ship-one');
    const corrections = () => {
      const { correctionsMismatch, correctionsLateInput, correctionsLostInput } = pilot.view().diagnosis;
      return correctionsMismatch + correctionsLateInput + correctionsLostInput;
    };
    let atStart = -1;
    await watchDrop(pilot, 'one', () => {
      if (atStart < 0) atStart = corrections();
    });
    const made = corrections() - atStart;
    pilot.dispose();
    console.log(
      `/stream at ${rate} Hz: ${made} corrections, last mismatch ${JSON.stringify(pilot.view().diagnosis.lastMismatch)}`,
    );
    expect(pilot.trouble).toEqual([]);
    expect(made).toBe(0);
  },
);
