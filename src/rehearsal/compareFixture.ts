import { accepted, type Checked, landedBodyName, readShip, type ShipRecord } from '../dynamics';
import type { Fixture, FixtureEvent, FixtureState } from './fixture';
import { startReplay } from './replayFixture';

/** Largest differences, component by component: m, m/s, 1 (attitude up to sign), rad/s, kg, m/s. */
export interface Differences {
  relativePosition: number;
  relativeVelocity: number;
  attitude: number;
  angularVelocity: number;
  fuel: number;
  impactSpeed: number;
}

export type DifferenceField = keyof Differences;

/** Two implementations of the law add in different orders; beyond these it is another law. */
export const TOLERANCES: Readonly<Differences> = Object.freeze({
  relativePosition: 1e-5,
  relativeVelocity: 1e-5,
  attitude: 1e-7,
  angularVelocity: 1e-7,
  fuel: 1e-6,
  impactSpeed: 1e-5,
});

/** How a replay compares with what its file says. */
export interface Comparison {
  readonly ticks: number;
  readonly statesCompared: number;
  readonly worst: Differences;
  /** The first value out of tolerance. */
  readonly outOfTolerance: { readonly tick: number; readonly field: DifferenceField } | null;
  /** The first tick that disagrees in state or event, and how. */
  readonly disagreement: { readonly tick: number; readonly how: string } | null;
}

export function agrees({ outOfTolerance, disagreement }: Comparison): boolean {
  return outOfTolerance === null && disagreement === null;
}

export function noDifferences(): Differences {
  return {
    relativePosition: 0,
    relativeVelocity: 0,
    attitude: 0,
    angularVelocity: 0,
    fuel: 0,
    impactSpeed: 0,
  };
}

/** Replays a fixture on the dynamics; a reason that names the field when the law refuses one. */
export function compareFixture(fixture: Fixture): Checked<Comparison> {
  const started = startReplay(fixture);
  if (!started.ok) return started;
  const replay = started.value;
  const worst = noDifferences();
  let outOfTolerance: Comparison['outOfTolerance'] = null;
  let disagreement: Comparison['disagreement'] = null;
  for (const expected of fixture.states) {
    while (replay.tick < expected.tick) replay.step();
    const ship = readShip(replay.ship, 0, replay.world);
    const field = raise(worst, ship, { ...expected, contactImpactSpeed: expected.impactSpeed });
    if (field !== null) outOfTolerance ??= { tick: expected.tick, field };
    const how = otherState(ship, expected);
    if (how !== null) disagreement ??= { tick: expected.tick, how };
  }
  while (replay.tick < (fixture.events.at(-1)?.tick ?? 0)) replay.step();
  const event = otherEvent(replay.events, fixture.events);
  if (event !== null && (disagreement === null || event.tick < disagreement.tick)) disagreement = event;
  const ticks = replay.tick - fixture.initial.tick;
  return accepted({ ticks, statesCompared: fixture.states.length, worst, outOfTolerance, disagreement });
}

/** What of a state is compared as numbers. */
export type Compared = Pick<
  ShipRecord,
  'relativePosition' | 'relativeVelocity' | 'attitude' | 'angularVelocity' | 'fuel' | 'contactImpactSpeed'
>;

/** Raises `worst` to the differences of two states; the first field out of tolerance, or null. */
export function raise(worst: Differences, ship: Compared, expected: Compared): DifferenceField | null {
  const found: Differences = {
    relativePosition: largest(ship.relativePosition, expected.relativePosition),
    relativeVelocity: largest(ship.relativeVelocity, expected.relativeVelocity),
    attitude: Math.min(
      largest(ship.attitude, expected.attitude),
      largest(
        ship.attitude,
        expected.attitude.map((value) => -value),
      ),
    ),
    angularVelocity: largest(ship.angularVelocity, expected.angularVelocity),
    fuel: Math.abs(ship.fuel - expected.fuel),
    impactSpeed: Math.abs(ship.contactImpactSpeed - expected.contactImpactSpeed),
  };
  let first: DifferenceField | null = null;
  for (const field of Object.keys(found) as DifferenceField[]) {
    // Math.max lets NaN through: a replay that lost its numbers is out of every tolerance.
    worst[field] = Math.max(worst[field], found[field]);
    if (!(found[field] <= TOLERANCES[field])) first ??= field;
  }
  return first;
}

function largest(a: readonly number[], b: readonly number[]): number {
  return Math.max(...a.map((value, i) => Math.abs(value - b[i]!)));
}

function otherState(ship: ShipRecord, expected: FixtureState): string | null {
  if (ship.crashed !== expected.crashed) return `crashed ${ship.crashed}, expected ${expected.crashed}`;
  if (ship.surfaceContactState !== expected.surfaceContactState)
    return `state '${ship.surfaceContactState}', expected '${expected.surfaceContactState}'`;
  const body = landedBodyName(ship);
  return body === expected.landedBodyName
    ? null
    : `landed_body_name '${body}', expected '${expected.landedBodyName}'`;
}

/** The first event that the two lists do not share, at the earlier of its two ticks. */
function otherEvent(
  events: readonly FixtureEvent[],
  expected: readonly FixtureEvent[],
): { tick: number; how: string } | null {
  for (let i = 0; i < Math.max(events.length, expected.length); i++) {
    const [a, b] = [events[i], expected[i]];
    if (a?.tick === b?.tick && a?.event === b?.event) continue;
    const tick = Math.min(a?.tick ?? Infinity, b?.tick ?? Infinity);
    return { tick, how: `${told(a)}, expected ${told(b)}` };
  }
  return null;
}

function told(event: FixtureEvent | undefined): string {
  return event === undefined ? 'no event' : `${event.event} at tick ${event.tick}`;
}
