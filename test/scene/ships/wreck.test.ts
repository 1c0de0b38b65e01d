import { describe, expect, it } from 'vitest';
import type { ShipActor } from '../../../src/scene/ships/shipActor';
import { crumple } from '../../../src/scene/ships/wreck';

function actorWith(blows: readonly [number, number, number]): ShipActor {
  return {
    place: Float64Array.of(5, 7, -3),
    turn: Float64Array.of(-Math.SQRT1_2, 0, 0, Math.SQRT1_2),
    blows: Float64Array.from(blows),
    compression: new Float32Array(4),
  } as unknown as ShipActor;
}

describe('wreck', () => {
  it('rests on its belly: legs folded, lowered by their length, leaning', () => {
    const actor = actorWith([0, -1, 0]);
    const before = [...actor.turn];
    crumple(actor, 4);
    const folded = actor.compression[0]!;
    // The legs, of the height of the centre of mass, folded by more than half, but not below the ground.
    expect(folded / 4).toBeGreaterThan(0.5);
    expect(folded / 4).toBeLessThan(0.6);
    expect([...actor.compression]).toEqual([folded, folded, folded, folded]);
    expect(7 - actor.place[1]!).toBeCloseTo(folded, 5);
    expect(Math.hypot(...actor.turn)).toBeCloseTo(1, 6);
    const same = before.reduce((sum, v, i) => sum + v * actor.turn[i]!, 0);
    const lean = (2 * Math.acos(Math.abs(same)) * 180) / Math.PI;
    expect(lean).toBeGreaterThan(10);
    expect(lean).toBeLessThan(30);
  });

  it('keeps its pose when it came down on its side', () => {
    const actor = actorWith([1, -0.1, 0]);
    crumple(actor, 4);
    expect([...actor.place]).toEqual([5, 7, -3]);
    expect([...actor.compression]).toEqual([0, 0, 0, 0]);
  });
});
