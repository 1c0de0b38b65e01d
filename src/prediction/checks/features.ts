import type { PartialFrame, ShipState } from '../../wire';
import { knowsGround } from '../ground/unknownGround';
import type { Session, SessionFeatures } from '../session';
import { sameBodies } from '../lifecycle/worldConfig';

/** Data or a call that needs a feature, the part of the session that the feature provides, and what happens without it. */
interface Need {
  readonly of: string;
  readonly feature: string;
  readonly part: keyof SessionFeatures;
  readonly isNeeded: (frame: PartialFrame, session: Session) => boolean;
  readonly effect: string;
}

const NEEDS: readonly Need[] = [
  {
    of: 'frame.events',
    feature: 'surfaceEvents',
    part: 'events',
    isNeeded: ({ events }) => listOf(events).length > 0,
    effect: 'they are ignored',
  },
  {
    of: 'onEvent',
    feature: 'surfaceEvents',
    part: 'events',
    isNeeded: (_frame, { listeners }) => listeners.size > 0,
    effect: 'its listener is never called',
  },
  {
    of: 'frame.lastInput',
    feature: 'inputAcknowledgements',
    part: 'acknowledgements',
    isNeeded: ({ lastInput }) => typeof lastInput === 'object' && lastInput !== null,
    effect: 'the controls in the states show which inputs were applied',
  },
  {
    of: 'a missing frame.timeScale',
    feature: 'measuredGameTime',
    part: 'gameTimeScale',
    isNeeded: ({ timeScale }) => timeScale === undefined,
    effect: 'the last one is used, or 1',
  },
  {
    of: 'a missing frame.tickRate',
    feature: 'measuredTickRate',
    part: 'tickRates',
    isNeeded: ({ tickRate }) => tickRate === undefined,
    effect: 'the last one is used, or 1 Hz',
  },
  {
    of: 'frame.bodies with missing, incomplete or reordered entries',
    feature: 'completedBodies',
    part: 'completeBodies',
    isNeeded: ({ bodies }, { sim }) => lacksBodies(bodies, sim.newestTick < 0 ? null : sim.world),
    effect: 'all bodies are extrapolated',
  },
  {
    of: 'frame.ships split over several messages',
    feature: 'snapshotParts',
    part: 'parts',
    isNeeded: ({ tick, ships }, { sim }) =>
      tick <= sim.newestTick &&
      (listOf(ships) as readonly ShipState[]).some(
        ({ shipId }) => (sim.fleet.byId.get(shipId)?.serverTick ?? -1) < tick,
      ),
    effect: 'the later ones are ignored',
  },
  {
    of: 'frame.ships with a contact without contactImpactSpeed',
    feature: 'replayedImpacts',
    part: 'replayImpact',
    isNeeded: ({ ships }) =>
      (listOf(ships) as readonly (Partial<ShipState> | null | undefined)[]).some(
        (ship) => ship?.surfaceContactState === 'contact' && (ship.contactImpactSpeed ?? null) === null,
      ),
    effect: 'a contact that was not predicted does not bounce',
  },
  {
    of: 'options.maxSubstepsPerFrame',
    feature: 'frameBudget',
    part: 'keepWithinBudget',
    isNeeded: (_frame, { options }) => options.maxSubstepsPerFrame !== undefined,
    effect: 'it limits replays only',
  },
  {
    of: 'a terrain that returns null',
    feature: 'unloadedGround',
    part: 'unknownGround',
    isNeeded: (_frame, session) => isAboveUnknownGround(session),
    effect: 'the ground there is at the body’s radius',
  },
];

/** Whether the ground below the newest state of the player's ship is not loaded. */
function isAboveUnknownGround({ sim, receiver }: Session): boolean {
  const { own } = sim.fleet;
  const { tick, bodies } = receiver.context;
  return own !== null && own.serverTick === tick && !knowsGround(own.serverRow, bodies, sim.world);
}

/** The list; an empty one for anything else that a JavaScript caller passes. */
const listOf = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);

function lacksBodies(
  bodies: PartialFrame['bodies'],
  world: Parameters<typeof sameBodies>[0] | null,
): boolean {
  if (!Array.isArray(bodies) || bodies.length === 0) return false;
  return (
    (world !== null && !sameBodies(world, { bodies })) ||
    bodies.some(({ attitude, angularVelocity }) => attitude === undefined || angularVelocity === undefined)
  );
}

/** Warns of data or calls that need a feature which this predictor does not have (createLeanPredictor). */
export function checkFeatures(session: Session, frame: PartialFrame): void {
  for (const { of, feature, part, isNeeded, effect } of NEEDS) {
    if (session.features[part] !== undefined || !isNeeded(frame, session)) continue;
    const message = `${of} needs the feature ${feature} of createLeanPredictor; without it, ${effect}.`;
    session.warn('feature-missing', message, { field: `${feature}: ${of}`, feature, tick: frame.tick });
  }
}
