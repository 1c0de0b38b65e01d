import { holdDrawn, POLICY_STALL } from '../drawn/correction';
import type { Session } from '../session';
import { abandonReplay, startReplay } from '../simulation/replay';
import type { Simulation } from '../simulation/simulation';
import { copyRow, type Policy, type Track } from '../simulation/track';

const POLICIES: readonly unknown[] = ['predict', 'interpolate', 'hold'] satisfies readonly Policy[];

/** Draws the ship by `policy` from now on, present or not. An invalid policy is ignored, with a warning. */
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

/** Holds the drawn pose, which fades into the pose of the policy. */
function leavePrediction(sim: Simulation, track: Track): void {
  abandonReplay(track);
  if (track.mode === 'stepping') holdDrawn(sim, track);
  sim.sleep?.holdSleeping(track);
  track.mode = 'held';
  track.off = false;
}

/** Simulates the ship from its newest server state; the drawn pose fades into the prediction. */
function returnToPrediction(sim: Simulation, track: Track): void {
  if (track.unpredictable || track.serverTick < 0) return;
  copyRow(sim.fleet.front, track.at, track.serverRow, 0);
  copyRow(sim.fleet.previous, track.at, track.serverRow, 0);
  track.picture.hasHeld = track.picture.view !== null;
  track.picture.skipped = POLICY_STALL;
  startReplay(track, sim, track.serverTick, track.serverRow, 0);
}
