import { describe, expect, it } from 'vitest';
import { createResolution, type Resolution } from '../../../src/playground/view/resolution';

/** Runs frames for some wall seconds at the rate that a machine reaches with the share of pixels; the shares it went through. */
function play(resolution: Resolution, seconds: number, rateAt: (share: number) => number): number[] {
  const shares = [resolution.share()];
  for (let now = 0; now < seconds; now += 1 / rateAt(resolution.share()))
    if (resolution.measure(now)) shares.push(resolution.share());
  return shares;
}

describe('resolution', () => {
  it('stays full on a machine that keeps up', () => {
    expect(play(createResolution(), 60, () => 60)).toEqual([1]);
  });

  it('is reduced step by step as far as a machine limited by pixels needs', () => {
    const resolution = createResolution();
    expect(play(resolution, 60, (share) => 15 / share ** 2)).toEqual([1, 0.8, 0.62]);
  });

  it('reverts a step that did not help, and tries again only much later', () => {
    const resolution = createResolution();
    expect(play(resolution, 30, () => 6)).toEqual([1, 0.8, 1]);
    expect(play(createResolution(), 60, () => 6)).toEqual([1, 0.8, 1, 0.8, 1]);
  });

  it('ignores the frame in which buffers of another size are created', () => {
    const resolution = createResolution();
    const shares = [resolution.share()];
    let hasChanged = false;
    for (let now = 0; now < 40; now += hasChanged ? 2 : 0.25 * resolution.share() ** 2) {
      hasChanged = resolution.measure(now);
      if (hasChanged) shares.push(resolution.share());
    }
    expect(shares).toEqual([1, 0.8, 0.62, 0.5]);
  });

  it('goes back up when the machine has headroom again', () => {
    const resolution = createResolution();
    play(resolution, 10, (share) => 10 / share ** 2);
    expect(resolution.share()).toBeLessThan(1);
    const shares: number[] = [];
    for (let now = 100; now < 160; now += 1 / 60)
      if (resolution.measure(now)) shares.push(resolution.share());
    expect(shares.at(-1)).toBe(1);
  });

  it('does not mistake a hidden tab for a slow machine', () => {
    const resolution = createResolution();
    for (let now = 0; now < 600; now += 60) expect(resolution.measure(now)).toBe(false);
  });
});
