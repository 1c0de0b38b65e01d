import { describe, expect, it } from 'vitest';
import { createRig, placeEye, updateRig } from '../../../src/scene/camera/cameraRig';

const STEP = 1 / 60;

describe('camera', () => {
  it('does not lag behind a steady flight', () => {
    const rig = createRig(2, 0.2, 20);
    const velocity = Float64Array.of(30, -4, 7);
    const place = new Float64Array(3);
    for (let n = 0; n < 300; n++) {
      for (let i = 0; i < 3; i++) place[i] = place[i]! + velocity[i]! * STEP;
      updateRig(rig, place, velocity, STEP);
    }
    const off = Math.hypot(...[0, 1, 2].map((i) => place[i]! - rig.focus[i]!));
    expect(off).toBeLessThan(0.02);
  });

  it('does not lurch at a correction: 2 m are spread over many frames, without a jump of rate', () => {
    const rig = createRig(2, 0.2, 20);
    const still = new Float64Array(3);
    const place = new Float64Array(3);
    updateRig(rig, place, still, STEP);
    place[0] = 2;
    let before = rig.focus[0]!;
    let largest = 0;
    let rate = 0;
    let jerk = 0;
    for (let n = 0; n < 180; n++) {
      updateRig(rig, place, still, STEP);
      const moved = rig.focus[0]! - before;
      largest = Math.max(largest, Math.abs(moved));
      jerk = Math.max(jerk, Math.abs(moved - rate));
      rate = moved;
      before = rig.focus[0]!;
    }
    expect(largest).toBeLessThan(0.07);
    expect(jerk).toBeLessThan(0.02);
    expect(Math.abs(rig.focus[0]! - 2)).toBeLessThan(1e-3);
  });

  it('follows a teleported ship at once, and stays above the ground', () => {
    const rig = createRig(1, -0.2, 30);
    updateRig(rig, new Float64Array(3), new Float64Array(3), STEP);
    updateRig(rig, Float64Array.of(500, 0, 0), new Float64Array(3), STEP);
    expect(rig.focus[0]).toBeGreaterThan(499);
    placeEye(rig, () => 12);
    expect(rig.eye[1]).toBeCloseTo(13, 6);
  });
});
