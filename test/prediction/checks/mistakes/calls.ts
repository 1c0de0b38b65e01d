/** Mistakes in calls and times: the mistake, the expected code, and a part of the expected message. */
import { NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import { type Mistake, frame, played, received, ship, ticks, warningsOf } from './given';

export const CALLS: readonly Mistake[] = [
  ['now is NaN', 'now-not-finite', /seconds/, () => warningsOf((p) => p.advance(null, NaN))],
  ['now in ms', 'now-in-milliseconds', /seconds/, () => played(1, { now: (s) => s * 1000 })],
  [
    'Unix time in seconds',
    'now-of-calendar',
    /performance/,
    () => played(1, { now: (s) => 1.8e9 + s, receiveAt: (s) => 1.8e9 + s }),
  ],
  [
    'Unix time in milliseconds',
    'now-of-calendar',
    /performance/,
    () => played(1, { now: (s) => 1.8e12 + 1000 * s }),
  ],
  [
    'both ways of taking',
    'outgoing-taken-twice',
    /takeControls for JSON/,
    () =>
      warningsOf((p) => {
        p.takeControls();
        p.takeOutgoing();
        p.takeControls();
      }),
  ],
  [
    'a removal of another name',
    'removal-unknown',
    /destroyed, docked, gone/,
    () => warningsOf((p) => p.removeShip('a', 'exploded' as 'gone')),
  ],
  [
    'view after dispose',
    'disposed',
    /view/,
    () =>
      warningsOf((p) => {
        p.dispose();
        p.view(1);
      }),
  ],
  [
    'game time in ms',
    'game-time',
    /seconds/,
    () => received(...ticks(12).map((one) => ({ ...one, gameTime: one.tick * 1000 }))),
  ],
  ['now goes back', 'now-went-back', /monotonic/, () => played(1, { now: (s) => (s < 0.5 ? s : s - 0.4) })],
  ['two clocks', 'two-clocks', /one clock for both/, () => played(1, { receiveAt: (s) => 1.7e9 + s })],
  [
    'advance never',
    'advance-never',
    /display frame/,
    () => received(...Array.from({ length: 12 }, (_, i) => ({ ...frame, tick: i + 1 }))),
  ],
  ['advance twelve times', 'advance-twice', /once is enough/, () => played(1, { times: 12 })],
  ['advance twice', 'advance-twice', /same now \(\d/, () => played(1, { times: 2 })],
  ['advance seldom', 'advance-seldom', /display frame/, () => played(4, { hz: 5 })],
  ['player’s ship never sent', 'own-ship-never-seen', /setOwnShip/, () => played(12, { id: 'b' })],
  [
    'player’s ship left out by the decoder',
    'own-ship-never-seen',
    /ships\[0\]\.fuel: missing/,
    () => received(...ticks(12, { ships: [], refusals: ['ships[0].fuel: missing'] })),
  ],
  ['nothing taken', 'outgoing-not-taken', /takeOutgoing/, () => played(8, { take: false })],
  [
    'a spectator steers',
    'controls-without-ship',
    /spectator/,
    () =>
      warningsOf(
        (p) => {
          p.receive(frame, 0);
          p.advance(NEUTRAL_CONTROLS, 0.01);
        },
        { ownShipId: undefined },
      ),
  ],
  [
    'a policy of another name',
    'policy-unknown',
    /predict, interpolate or hold/,
    () => warningsOf((p) => p.setPolicy('a', 'extrapolate' as 'hold')),
  ],
  [
    'a listener that is not a function',
    'listener-not-function',
    /function/,
    () => warningsOf((p) => p.onEvent(undefined as unknown as () => void)),
  ],
  [
    'advance(now)',
    'now-not-finite',
    /seconds/,
    () => warningsOf((p) => p.advance(12.5 as unknown as null, undefined as unknown as number)),
  ],
  [
    'now as a Date',
    'now-not-finite',
    /seconds/,
    () => warningsOf((p) => p.advance(null, new Date(0) as unknown as number)),
  ],
  [
    'view without now',
    'now-not-finite',
    /seconds/,
    () => warningsOf((p) => p.view(undefined as unknown as number)),
  ],
  ['view with Date.now()', 'two-clocks', /view/, () => played(1, { viewAt: () => 1.7e12 })],
  ['now never changes', 'advance-twice', /same now/, () => played(1, { now: () => 5, receiveAt: () => 5 })],
  [
    'Date.now() for all',
    'now-in-milliseconds',
    /performance\.now/,
    () => played(1, { now: (s) => 1.7e12 + s * 1000, receiveAt: (s) => 1.7e12 + s * 1000 }),
  ],
  [
    'view and no advance',
    'advance-never',
    /view/,
    () =>
      warningsOf((p) => {
        p.receive(frame, 0);
        for (let i = 0; i < 12; i++) p.view(i / 60);
      }),
  ],
  ['advance in a timer of one second', 'advance-seldom', /display frame/, () => played(14, { hz: 1 })],
  [
    'a number for the player’s ship',
    'ship-id',
    /setOwnShip.*7/,
    () => warningsOf((p) => p.setOwnShip(7 as unknown as string)),
  ],
  [
    'nothing for the player’s ship',
    'ship-id',
    /setOwnShip.*undefined/,
    () => warningsOf((p) => p.setOwnShip(undefined as unknown as string)),
  ],
  [
    'a ship for its id',
    'ship-id',
    /removeShip/,
    () => warningsOf((p) => p.removeShip(ship as unknown as string, 'gone')),
  ],
  [
    'onEvent with a name',
    'listener-not-function',
    /one function.*all events/,
    () => warningsOf((p) => (p.onEvent as unknown as (name: string) => void)('landed')),
  ],
  [
    'a listener that throws',
    'listener-threw',
    /fix it/,
    () =>
      warningsOf((p) => {
        p.onEvent(() => {
          throw new Error('mine');
        });
        p.receive(frame, 0);
        p.removeShip('a', 'destroyed');
      }),
  ],
  [
    'a frame loop that continues after dispose',
    'disposed',
    /advance.*stop the frame loop/,
    () =>
      warningsOf((p) => {
        p.dispose();
        p.advance(null, 1);
        p.receive(frame, 1);
      }),
  ],
  [
    'restore of a string',
    'restore-refused',
    /JSON\.parse/,
    () => warningsOf((p) => p.restore('{"version":1}', 0)),
  ],
  [
    'restore of another version',
    'restore-refused',
    /expected 1, got 2/,
    () => warningsOf((p) => p.restore({ version: 2 }, 0)),
  ],
];
