import { Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { createMissionTracker } from '../../../../src/playground/game/mission/missionTracker';
import type { ShipView } from '../../../../src/prediction';
import { findMission, loadScenario, padPlaces } from '../../../../src/scenarios';
import { valueOf } from '../../../authority/moon';
import { makeView } from '../../../readout/views';

/** A turned body that spins about no axis, so that each component counts. */
const TURNED = new Quaternion(0.1, -0.2, 0.3, 0.9).normalize();
const SPIN = new Vector3(1e-3, -2e-3, 3e-3);

interface Seen extends Partial<ShipView> {
  /** m along the ground from a pad, by its index. */
  readonly beside?: number;
  readonly pad?: number;
  /** m/s relative to the ground, along one axis. */
  readonly over?: readonly [x: number, y: number, z: number];
}

/** A tracker of the mission, and its phase after it has seen a ship, `passed` game s after the one before. */
function begin(name: string) {
  const mission = findMission(name)!;
  const places = padPlaces(mission, valueOf(loadScenario(mission.scenario)));
  const tracker = createMissionTracker();
  tracker.begin(mission);
  let sinceTick = 0;
  const see = ({ beside = 0, pad = 0, over = [0, 0, 0], ...changes }: Seen, passed = 1) => {
    sinceTick += passed;
    const view = { ...makeView({}, changes), tick: 0, sinceTick };
    const { own, bodies } = view;
    const turned = { attitude: TURNED.toArray(), angularVelocity: SPIN.toArray() };
    bodies[own.body] = { ...bodies[own.body]!, ...turned };
    const place = new Vector3(...places[pad]!).applyQuaternion(TURNED);
    const across = new Vector3(1, 2, -2).cross(place).setLength(beside);
    const position = place.clone().multiplyScalar(1.00001).add(across);
    own.position.set(position.toArray());
    own.velocity.set(
      SPIN.clone()
        .cross(position)
        .add(new Vector3(...over))
        .toArray(),
    );
    tracker.watch(view);
    return tracker.phase();
  };
  return { tracker, see };
}

describe('a lesson to fly over the beacon', () => {
  const phaseOf = (seen: Seen) => begin('school-translate').see({ feetHeight: 40, ...seen });

  it('is done over it, below its height, slower than its speed over the turning ground in any direction', () => {
    expect([phaseOf({}), phaseOf({ beside: 11.9 }), phaseOf({ beside: 12.1 })]).toEqual([
      ...['done', 'done', 'flying'],
    ]);
    expect([phaseOf({ feetHeight: 119.9 }), phaseOf({ feetHeight: 120 })]).toEqual(['done', 'flying']);
    for (const along of [0, 1, 2])
      for (const speed of [-1, 1]) {
        const at = (value: number) =>
          phaseOf({ over: [0, 1, 2].map((k) => (k === along ? speed * value : 0)) as never });
        expect([at(2.99), at(3.01)], `axis ${along}`).toEqual(['done', 'flying']);
      }
  });

  it('is not done by standing there, nor before the server confirms a touch', () => {
    expect(phaseOf({ shownState: 'landed' })).toBe('beside');
    expect(phaseOf({ shownState: 'landed', provenance: 'predicted' })).toBe('flying');
    expect(phaseOf({ provenance: 'predicted' })).toBe('done');
  });
});

describe('a lesson to hover', () => {
  it('is done after its seconds between its heights, which start anew outside and on the ground', () => {
    const { tracker, see } = begin('school-hover');
    const held = (seen: Seen, passed: number) => {
      see(seen, passed);
      return tracker.held();
    };
    expect(held({ feetHeight: 40 }, 5)).toBe(0);
    expect([held({ feetHeight: 20 }, 4), held({ feetHeight: 60 }, 4)]).toEqual([4, 8]);
    expect([held({ feetHeight: 60.1 }, 1), held({ feetHeight: 40 }, 1)]).toEqual([0, 1]);
    expect([held({ feetHeight: 19.9 }, 1), held({ feetHeight: 40 }, 2)]).toEqual([0, 2]);
    // The clock of a view may be set back.
    expect(held({ feetHeight: 40 }, -1)).toBe(2);
    expect([held({ feetHeight: 40, shownState: 'landed' }, 1), held({ feetHeight: 40 }, 4)]).toEqual([0, 4]);
    expect([see({ feetHeight: 40 }, 5.9), see({ feetHeight: 40 }, 0.1)]).toEqual(['flying', 'done']);
  });
});

describe('a mission of several pads', () => {
  it('marks the next one, and is done on the last', () => {
    const { tracker, see } = begin('relay');
    const marked = () => tracker.pads().map(({ isNext, radius }) => (isNext ? radius : 0));
    expect(tracker.target()).toBeNull();
    expect([see({ beside: 30 }), tracker.isOverPad(), tracker.target()!.radius]).toEqual([
      'flying',
      false,
      25,
    ]);
    expect([see({ beside: 24.9 }), tracker.isOverPad()]).toEqual(['flying', true]);
    expect([see({ beside: 25.1, shownState: 'landed' }), tracker.reached()]).toEqual(['beside', 0]);
    expect(tracker.off()).toBeCloseTo(25.1, 3);
    see({});
    expect(see({ beside: 3, shownState: 'landed' })).toBe('padReached');
    expect([tracker.reached(), marked()]).toEqual([1, [0, 20, 0]]);
    expect(tracker.off()).toBeCloseTo(3, 3);
    // Still on the first.
    expect(see({ beside: 3, shownState: 'landed' })).toBe('padReached');
    see({ pad: 1 });
    expect([see({ pad: 1, shownState: 'landed' }), marked()]).toEqual(['padReached', [0, 0, 15]]);
    see({ pad: 2 });
    expect([see({ pad: 2, beside: 14.9, shownState: 'landed' }), tracker.reached()]).toEqual(['done', 3]);
    expect([see({ pad: 2, shownState: 'crashed' }), see({ pad: 2 })]).toEqual(['done', 'done']);
  });

  it('goes on after a fall, not after a crash, and begins anew', () => {
    const { tracker, see } = begin('relay');
    expect([see({ shownState: 'tipped' }), see({}), see({ shownState: 'landed' })]).toEqual([
      ...['tipped', 'flying', 'padReached'],
    ]);
    expect([see({ shownState: 'crashed' }), see({})]).toEqual(['crashed', 'crashed']);
    tracker.begin(findMission('relay'));
    expect([tracker.phase(), tracker.reached(), tracker.off(), tracker.target()]).toEqual([
      ...['flying', 0, NaN, null],
    ]);
  });

  it('watches nothing without a mission or a ship', () => {
    const tracker = createMissionTracker();
    expect([tracker.watch(makeView()), tracker.pads(), tracker.mission()]).toEqual([false, [], null]);
    tracker.begin(findMission('relay'));
    const view = makeView({}, { shownState: 'crashed' });
    expect([tracker.watch({ ...view, ready: false }), tracker.watch({ ...view, own: null })]).toEqual([
      ...[false, false],
    ]);
    expect([tracker.watch(view), tracker.watch(view)]).toEqual([true, false]);
  });
});
