import {
  ATTITUDE_MODES,
  type Controls,
  err,
  loadControls,
  NEUTRAL_CONTROLS,
  ok,
  type Result,
  type Vec3,
} from '../../dynamics';
import type { RunInput } from './flyRun';

/** Resolution of the page's lever and sticks: controls on this grid are restored to the same bits. */
const LEVER_STEP = 0.005;
const STICK_STEPS = 100;

const [THRUST, TURN, PUSH, MODE, TARGET] = [1, 2, 4, 8, 16] as const;
/** More would not fit into a link. */
const MAX_INPUTS = 20_000;

/**
 * Encodes a run's inputs compactly: for each, the substeps since the one before (varint), flags of what changed, and the new values.
 * Controls are rounded to the page's grid, so compare only runs that were decoded.
 */
export function writeRun(inputs: readonly RunInput[], substepsPerTick: number): Uint8Array {
  const bytes: number[] = [];
  let before: Controls = NEUTRAL_CONTROLS;
  let last = 0;
  for (const { tick, substep, controls } of inputs) {
    const at = tick * substepsPerTick + substep;
    varint(bytes, at - last);
    last = at;
    const parts: number[] = [];
    let changed = 0;
    const lever = (c: Controls) => Math.round(c.thrustLevel / LEVER_STEP);
    if (lever(controls) !== lever(before)) {
      changed |= THRUST;
      parts.push(lever(controls));
    }
    changed |= triple(parts, TURN, controls.rotationInput, before.rotationInput);
    changed |= triple(parts, PUSH, controls.translationInput, before.translationInput);
    if (modeByte(controls) !== modeByte(before)) {
      changed |= MODE;
      parts.push(modeByte(controls));
    }
    if (controls.targetAttitude.some((value, k) => value !== before.targetAttitude[k])) {
      changed |= TARGET;
      parts.push(...new Uint8Array(Float64Array.from(controls.targetAttitude).buffer));
    }
    bytes.push(changed, ...parts);
    before = controls;
  }
  return Uint8Array.from(bytes);
}

/** Decodes the inputs of a run, or returns a reason why the bytes are invalid. */
export function readRun(bytes: Uint8Array, substepsPerTick: number): Result<RunInput[]> {
  const inputs: RunInput[] = [];
  let controls: Controls = NEUTRAL_CONTROLS;
  let at = 0;
  let next = 0;
  const take = (count: number): Uint8Array | null => {
    const part = bytes.subarray(next, next + count);
    next += count;
    return part.length === count ? part : null;
  };
  while (next < bytes.length) {
    if (inputs.length >= MAX_INPUTS) return err(`inputs: expected at most ${MAX_INPUTS}`);
    let passed = 0;
    let scale = 1;
    let byte = 0x80;
    while (byte >= 0x80) {
      byte = take(1)?.[0] ?? -1;
      if (byte < 0 || scale > 2 ** 28) return err(`inputs[${inputs.length}]: cut short`);
      passed += (byte & 0x7f) * scale;
      scale *= 128;
    }
    at += passed;
    const read = readControls(controls, take);
    if (!read.ok) return err(`inputs[${inputs.length}].${read.reason}`);
    controls = read.value;
    inputs.push({ tick: Math.floor(at / substepsPerTick), substep: at % substepsPerTick, controls });
  }
  return ok(inputs);
}

function readControls(before: Controls, take: (count: number) => Uint8Array | null): Result<Controls> {
  const changed = take(1)?.[0];
  if (changed === undefined) return err('changed: cut short');
  const next = { ...before };
  const read = (flag: number, count: number, keep: (part: Uint8Array) => void): boolean => {
    if ((changed & flag) === 0) return true;
    const part = take(count);
    if (part !== null) keep(part);
    return part !== null;
  };
  const whole =
    read(THRUST, 1, ([value]) => (next.thrustLevel = value! * LEVER_STEP)) &&
    read(TURN, 3, (part) => (next.rotationInput = readTriple(part))) &&
    read(PUSH, 3, (part) => (next.translationInput = readTriple(part))) &&
    read(MODE, 1, ([value]) => {
      next.attitudeHold = (value! & 0x80) !== 0;
      next.attitudeMode = ATTITUDE_MODES[value! & 0x7f] ?? 'none';
    }) &&
    read(TARGET, 32, (part) => {
      const [x, y, z, w] = new Float64Array(part.slice().buffer);
      next.targetAttitude = [x!, y!, z!, w!];
    });
  return whole ? loadControls(next) : err('cut short');
}

function varint(bytes: number[], value: number): void {
  let rest = value;
  while (rest >= 0x80) {
    bytes.push((rest % 128) | 0x80);
    rest = Math.floor(rest / 128);
  }
  bytes.push(rest);
}

function steps(v: Vec3): number[] {
  return v.map((value) => Math.round(value * STICK_STEPS) + 128);
}

function triple(parts: number[], flag: number, now: Vec3, before: Vec3): number {
  const [a, b] = [steps(now), steps(before)];
  if (a.every((value, k) => value === b[k])) return 0;
  parts.push(...a);
  return flag;
}

function readTriple(part: Uint8Array): Vec3 {
  const value = (k: number) => (part[k]! - 128) / STICK_STEPS + 0;
  return [value(0), value(1), value(2)];
}

function modeByte(controls: Controls): number {
  const mode = controls.attitudeMode === 'unknown' ? 'none' : controls.attitudeMode;
  return ATTITUDE_MODES.indexOf(mode) | (controls.attitudeHold ? 0x80 : 0);
}
