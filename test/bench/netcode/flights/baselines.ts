import { GRAVITATIONAL_CONSTANT } from '../../../../src/dynamics';
import type { WorldView } from '../../../../src/prediction';
import type { ServerFrame, ShipState } from '../../../../src/wire';
import { distance, type Sample } from '../../../prediction/samples';

/**
 * Drawing without prediction, from the same frames and for the same instants: the last state held; the current client's gravity-only
 * extrapolation, whose jump at a new state is blended; snapshots interpolated one tick behind, so that two are always available.
 */
export interface Baselines {
  readonly receive: (frame: ServerFrame, now: number) => void;
  readonly draw: (view: WorldView, now: number) => void;
  /** Error of each at a sample's frame, m; null if one of them has too few states. */
  readonly errors: (sample: Sample, truth: readonly number[]) => Drawn | null;
}

interface Drawn {
  readonly hold: number;
  readonly gravity: number;
  readonly behind: number;
}

interface Place {
  readonly hold: readonly number[];
  readonly gravity: readonly number[];
  readonly behind: readonly number[] | null;
}

interface Known {
  readonly tick: number;
  readonly position: readonly number[];
  readonly velocity: readonly number[];
}

/** s after which the blend leaves 5 %, as in the current client. */
const BLEND = 0.5;
const BLEND_RATE = 3 / BLEND;

export function baselines(): Baselines {
  const snapshots = new Map<string, Known[]>();
  const offsets = new Map<string, { offset: number[]; at: number }>();
  const lastDrawn = new Map<string, readonly number[]>();
  const drawn = new Map<string, Place>();
  const fresh = new Set<string>();
  let mass = 0;

  function extrapolated(known: Known, seconds: number): number[] {
    const [x, y, z] = known.position as [number, number, number];
    const pull = (-GRAVITATIONAL_CONSTANT * mass) / (x * x + y * y + z * z) ** 1.5;
    return known.position.map(
      (p, k) => p + known.velocity[k]! * seconds + 0.5 * pull * p * seconds * seconds,
    );
  }

  function blended(shipId: string, target: number[], now: number): number[] {
    const before = offsets.get(shipId);
    const left =
      before === undefined
        ? [0, 0, 0]
        : before.offset.map((o) => o * Math.exp(-BLEND_RATE * (now - before.at)));
    const last = lastDrawn.get(shipId);
    const offset = fresh.has(shipId) && last !== undefined ? last.map((p, k) => p - target[k]!) : left;
    fresh.delete(shipId);
    offsets.set(shipId, { offset, at: now });
    const place = target.map((p, k) => p + offset[k]!);
    lastDrawn.set(shipId, place);
    return place;
  }

  return {
    receive(frame) {
      mass = frame.bodies[0]!.mass;
      for (const ship of frame.ships) {
        const kept = [...(snapshots.get(ship.shipId) ?? []), knownOf(ship, frame.tick)];
        snapshots.set(ship.shipId, kept.slice(-4));
        fresh.add(ship.shipId);
      }
    },
    draw(view, now) {
      const present = view.tick + view.sinceTick * (view.tickRate / view.timeScale);
      for (const [shipId, kept] of snapshots) {
        const newest = kept.at(-1)!;
        const seconds = ((present - newest.tick) * view.timeScale) / view.tickRate;
        const gravity = blended(shipId, extrapolated(newest, seconds), now);
        const key = `${shipId} ${now}`;
        drawn.set(key, { hold: newest.position, gravity, behind: interpolated(kept, present - 1) });
      }
    },
    errors(sample, truth) {
      const place = drawn.get(`${sample.shipId} ${sample.wall}`);
      if (place === undefined || place.behind === null) return null;
      return {
        hold: distance(place.hold, truth),
        gravity: distance(place.gravity, truth),
        behind: distance(place.behind, truth),
      };
    },
  };
}

function knownOf(ship: ShipState, tick: number): Known {
  return { tick, position: ship.relativePosition!, velocity: ship.relativeVelocity! };
}

/** Interpolates between the two snapshots around `tick`, or holds the newest. */
function interpolated(kept: readonly Known[], tick: number): readonly number[] | null {
  for (let i = kept.length - 1; i > 0; i--) {
    const [a, b] = [kept[i - 1]!, kept[i]!];
    if (a.tick > tick) continue;
    const share = Math.min(1, (tick - a.tick) / (b.tick - a.tick));
    return a.position.map((p, k) => p + (b.position[k]! - p) * share);
  }
  return null;
}
