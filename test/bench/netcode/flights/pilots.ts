import { type Controls, NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import { createRandom, type Random } from '../../../../src/scenarios';
import type { Rig } from '../../../prediction/rig';

/** A pilot who changes one control after exponential intervals of mean 2 s: thrust around hovering on the Moon, thrusters, attitude. */
export interface SeededPilot {
  readonly at: (now: number) => Controls;
  /** Wall s of the next change. */
  readonly nextAt: () => number;
}

const MEAN = 2;
/** Hovering takes 0.1 of the lander's thrust on the Moon. */
const LEVELS = [0, 0.05, 0.1, 0.15, 0.2];
const MODES = ['none', 'hold', 'radial', 'retrograde'] as const;

export function createSeededPilot(seed: number): SeededPilot {
  const rng = createRandom(seed);
  let controls: Controls = { ...NEUTRAL_CONTROLS, attitudeHold: true };
  let next = interval(rng);
  return {
    nextAt: () => next,
    at(now) {
      while (now >= next) {
        controls = changed(controls, rng);
        next += interval(rng);
      }
      return controls;
    },
  };
}

/** Exponential, by inverse transform; the logarithm is a sum of ln 2s and a series, since engines differ in theirs. */
function interval(rng: Random): number {
  let u = 1 - rng();
  let log = 0;
  while (u < 0.5) {
    u *= 2;
    log += 0.6931471805599453;
  }
  const z = (1 - u) / (1 + u);
  let term = z;
  for (let n = 1; n < 40; n += 2) {
    log += (2 * term) / n;
    term *= z * z;
  }
  return MEAN * log;
}

function changed(controls: Controls, rng: Random): Controls {
  const which = rng();
  const stick = () => Math.floor(rng() * 3) - 1;
  if (which < 0.4) return { ...controls, thrustLevel: LEVELS[Math.floor(rng() * LEVELS.length)]! };
  if (which < 0.7) return { ...controls, translationInput: [stick(), stick(), 0] };
  if (which < 0.85) return { ...controls, attitudeMode: MODES[Math.floor(rng() * MODES.length)]! };
  return { ...controls, rotationInput: [0.03 * stick(), 0.03 * stick(), 0.03 * stick()] };
}

/** Other players on the same server, whose inputs arrive in time: each change is stamped with its substep. */
export function flyOthers(rig: Rig, count: number, seed: number): (rig: Rig) => void {
  const pilots = Array.from({ length: count }, (_, i) => ({
    playerId: `player-${i + 1}`,
    pilot: createSeededPilot(seed + i),
    seq: 0,
  }));
  for (const [i, { playerId }] of pilots.entries()) rig.authority.join(playerId, `other-${i + 1}`);
  return ({ authority, exchange, now }) => {
    const { substeps } = authority.tempo.timing();
    const tickRate = authority.tempo.tickRate();
    const share = 1 - (exchange.loop.nextAt - now) * tickRate;
    const substep = Math.min(substeps - 1, Math.max(0, Math.floor(share * substeps)));
    for (const other of pilots) {
      if (now < other.pilot.nextAt()) continue;
      other.seq += 1;
      const record = { seq: other.seq, tick: authority.tickNumber(), substep, controls: other.pilot.at(now) };
      authority.receive(other.playerId, { kind: 'inputs', inputs: [record] }, now);
    }
  };
}
