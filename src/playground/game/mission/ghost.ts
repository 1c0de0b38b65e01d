import { quat } from 'gl-matrix';
import type { ShipView, WorldView } from '../../../prediction';
import { NEUTRAL_CONTROLS } from '../../../dynamics';
import { toInertial } from '../../../readout';
import { TRACK_RATE, TRACK_STRIDE } from '../../../scenarios';
import type { VerifiedRun } from './bestRuns';
import { gameSeconds } from './missionTracker';

const place = new Float64Array(3);
const bodyAttitude = new Float64Array(4);
const turn = new Float64Array(4);

/** ID of the ghost in the picture, which no ship of a server has. */
export const GHOST_SHIP = 'ghost of a run';

/** Shows a verified run beside the pilot: a ship in the picture without effect. */
export interface GhostFlight {
  /** The view with the ghost in it; the same view without a run. */
  readonly join: (view: WorldView) => WorldView;
  readonly race: (run: VerifiedRun | null) => void;
  readonly run: () => VerifiedRun | null;
}

export function createGhostFlight(): GhostFlight {
  let run: VerifiedRun | null = null;
  let ship: ShipView | null = null;
  return {
    race(next) {
      run = next;
      ship = null;
    },
    run: () => run,
    join(view) {
      const own = view.own;
      if (run === null || own === null || !view.ready) return view;
      if (ship?.shipClass !== own.shipClass) ship = ghostOf(own, run);
      pose(ship, view, run.outcome.track);
      return { ...view, ships: [...view.ships, ship] };
    },
  };
}

function ghostOf(own: ShipView, run: VerifiedRun): ShipView {
  const copy = (row: Float64Array) => new Float64Array(row.length);
  return {
    ...own,
    shipId: GHOST_SHIP,
    name: run.by === '' ? 'Your best' : run.by,
    own: false,
    controls: NEUTRAL_CONTROLS,
    crashed: false,
    surfaceContactState: '',
    shownState: '',
    impactSpeed: 0,
    position: copy(own.position),
    velocity: copy(own.velocity),
    attitude: copy(own.attitude),
    angularVelocity: copy(own.angularVelocity),
    wheelMomentum: copy(own.wheelMomentum),
    thrust: copy(own.thrust),
    easedPosition: copy(own.easedPosition),
    meshAttitude: copy(own.meshAttitude),
    meshPosition: copy(own.meshPosition),
    legCompression: copy(own.legCompression),
    serverKnown: false,
  };
}

/** Linear between two positions of the track; an attitude changes little in a tenth of a second. */
function pose(ship: ShipView, view: WorldView, track: Float64Array): void {
  const body = view.bodies[view.own!.body]!;
  ship.body = view.own!.body;
  bodyAttitude.set(body.attitude);
  const last = track.length / TRACK_STRIDE - 1;
  const at = Math.min(Math.max(gameSeconds(view) * TRACK_RATE, 0), last);
  const from = Math.floor(at);
  const to = Math.min(from + 1, last);
  const share = at - from;
  const value = (k: number) =>
    track[from * TRACK_STRIDE + k]! * (1 - share) + track[to * TRACK_STRIDE + k]! * share;
  for (let k = 0; k < 3; k++) place[k] = value(k);
  toInertial(ship.meshPosition, bodyAttitude, place);
  ship.position.set(ship.meshPosition);
  ship.easedPosition.set(ship.meshPosition);
  for (let k = 0; k < 4; k++) turn[k] = value(3 + k);
  quat.multiply(turn, bodyAttitude, turn);
  quat.normalize(ship.meshAttitude, turn);
  ship.attitude.set(ship.meshAttitude);
}
