import { holdDrawn, POLICY_STALL } from '../drawn/correction';
import type { Session } from '../session';
import { abandonReplay, startReplay } from '../simulation/replay';
import type { Simulation } from '../simulation/simulation';
import { holdSleeping } from '../simulation/sleep';
import { copyRow, type Policy, type Track } from '../simulation/track';

const POLICIES: readonly unknown[] = ['predict', 'interpolate', 'hold'] satisfies readonly Policy[];

/** From now on the ship is drawn by `policy`, whether it is there yet or not. Anything else than a policy is ignored, with a warning. */
export function changePolicy({ sim, receiver, warn }: Session, shipId: string, policy: Policy): void {
  if (!POLICIES.includes(policy)) {
    const message = `setPolicy(${JSON.stringify(shipId)}, ${JSON.stringify(policy)}): expected predict, interpolate or hold. The call was ignored.`;
    warn('policy-unknown', message, { shipId, policy });
    return;
  }
  if (policy === 'predict') receiver.policies.delete(shipId);
  else receiver.policies.set(shipId, policy);
  const track = sim.fleet.byId.get(shipId);
  if (track === undefined || track.policy === policy) return;
  if (track.policy === 'predict') leavePrediction(sim, track);
  else if (policy === 'predict') returnToPrediction(sim, track);
  track.policy = policy;
  track.states = null;
}

/** Where it is drawn now is held, and fades into where the policy has it. */
function leavePrediction(sim: Simulation, track: Track): void {
  abandonReplay(track);
  if (track.mode === 'stepping') holdDrawn(sim, track);
  if (track.mode === 'sleeping') holdSleeping(track);
  track.mode = 'held';
  track.off = false;
}

/** Simulated from its newest server state on; where it is drawn now fades into that. */
function returnToPrediction(sim: Simulation, track: Track): void {
  if (track.unpredictable || track.serverTick < 0) return;
  copyRow(sim.fleet.front, track.at, track.serverRow, 0);
  copyRow(sim.fleet.previous, track.at, track.serverRow, 0);
  track.picture.hasHeld = track.picture.view !== null;
  track.picture.skipped = POLICY_STALL;
  startReplay(track, sim, track.serverTick, track.serverRow, 0);
}
