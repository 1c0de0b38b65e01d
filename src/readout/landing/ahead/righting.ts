import type { ShipView, WorldView } from '../../../prediction';
import {
  ROTATION_ACTIONS,
  type RotationAction,
  TRANSLATION_ACTIONS,
  type TranslationAction,
} from '../../actions';
import { createRightingRun, forgetRightingRun, type RightingRun, runRighting } from './rightingRun';
import type { Surface } from '../../surface';
import { toppleTilt } from '../tilt';

/** How a tipped ship gets up again, or why it cannot (HUD, righting help; DYNAMICS, "What this gives"). */
export interface Righting {
  /** While tipped, and while the ship comes up under the actions named, until they are let go. */
  shown: boolean;
  /** Let go now: it leans less than `holdUntil`, or over to its other side. */
  release: boolean;
  /** One action, or two when the ship lies across its axes. */
  readonly actions: RotationAction[];
  /** Wheel + RCS about the righting axis with those actions held, N m. */
  torqueAvailable: number;
  /** weight · h, N m. */
  torqueNeeded: number;
  /** The torque suffices. */
  possible: boolean;
  /** kg on board. */
  fuel: number;
  /**
   * Result of simulating ahead: those actions held until the tilt is below `holdUntil`, then rate damping.
   * 'fails': the ship does not land within a minute (fuel ran out, or it falls over again).
   */
  outcome: 'working' | 'lands' | 'fails';
  /** Game s to hold, and kg until landed; NaN unless outcome is 'lands'. */
  holdSeconds: number;
  fuelNeeded: number;
  /** Degrees of tilt from the ground: hold until the tilt is below it. Once computed, it is above the point of no return by the turn in the hand's reaction time. */
  holdUntil: number;
  /** Rate damping is on already: releasing the keys suffices. */
  damped: boolean;
  /** Other help when the torque does not suffice. */
  help: 'none' | 'translation' | 'lighter';
  /** For help 'translation': the thruster that takes the most weight off the feet. */
  helpAction: TranslationAction | '';
  /** For help 'lighter': mass below which the torque suffices, kg; else NaN. */
  helpMass: number;
}

export interface RightingMemory {
  /** rotation_input of the actions. */
  readonly inputs: Float64Array;
  readonly run: RightingRun;
}

/** tan 22.5°: from here on two keys together point nearer to the righting axis than the better one alone. */
const SECOND_KEY = 0.414;

export function createRighting(): Righting {
  return {
    shown: false,
    release: false,
    actions: [],
    torqueAvailable: NaN,
    torqueNeeded: NaN,
    possible: false,
    fuel: NaN,
    outcome: 'working',
    holdSeconds: NaN,
    fuelNeeded: NaN,
    holdUntil: NaN,
    damped: false,
    help: 'none',
    helpAction: '',
    helpMass: NaN,
  };
}

export function createRightingMemory(): RightingMemory {
  return { inputs: new Float64Array(3), run: createRightingRun() };
}

/** For a tipped ship. A ship at rest costs no substep once its run has ended. */
export function measureRighting(
  out: Righting,
  memory: RightingMemory,
  surface: Surface,
  view: WorldView,
  ship: ShipView,
): void {
  out.shown = true;
  out.release = false;
  out.fuel = ship.fuel;
  out.torqueNeeded = surface.weight * ship.groundContactOffset;
  out.damped = ship.controls.attitudeHold && ship.controls.attitudeMode === 'none';
  chooseActions(out, memory.inputs, surface, ship);
  out.possible = out.torqueAvailable > out.torqueNeeded;
  chooseHelp(out, surface, ship);
  if (out.possible) runRighting(memory.run, memory.inputs, surface, view, ship);
  else forgetRightingRun(memory.run);
  out.outcome = memory.run.outcome;
  out.holdSeconds = memory.run.holdSeconds;
  writeHoldUntil(out, memory, surface);
  out.fuelNeeded = memory.run.fuelNeeded;
}

function writeHoldUntil(out: Righting, { run }: RightingMemory, surface: Surface): void {
  const earlier = Number.isNaN(run.holdLean) ? 0 : run.holdLean - surface.noReturn;
  out.holdUntil = toppleTilt(surface) + (earlier * 180) / Math.PI;
}

/** For a ship that was tipped and is in contact: whether it is being righted. The help stays until the keys are let go. */
export function followRighting(
  out: Righting,
  memory: RightingMemory,
  surface: Surface,
  { controls }: ShipView,
): boolean {
  const { inputs, run } = memory;
  const isHeld = inputs[0]! * controls.rotationInput[0] + inputs[1]! * controls.rotationInput[1] > 0;
  out.shown = isHeld && run.outcome === 'lands';
  if (!out.shown) return false;
  writeHoldUntil(out, memory, surface);
  // Leaning over further, it has swung past upright.
  out.release = surface.tiltRate > 0 || (surface.tilt * 180) / Math.PI < out.holdUntil;
  return true;
}

/** The turn that brings `up` back to s is about up × s, which in ship axes has no z. Upside down, any axis will do. */
function chooseActions(out: Righting, inputs: Float64Array, surface: Surface, ship: ShipView): void {
  const x = -surface.groundInShip[1]!;
  const y = surface.groundInShip[0]!;
  const level = Math.sqrt(x * x + y * y);
  const shareX = level > 0 ? Math.abs(x) / level : 1;
  const shareY = level > 0 ? Math.abs(y) / level : 0;
  writeAvailableTorque(torque, ship);
  const torqueX = shareX * torque[0]!;
  const torqueY = shareY * torque[1]!;
  const xFirst = torqueX >= torqueY;
  const useX = xFirst || shareX > SECOND_KEY * shareY;
  const useY = !xFirst || shareY > SECOND_KEY * shareX;
  inputs[0] = useX ? (x < 0 ? -1 : 1) : 0;
  inputs[1] = useY ? (y < 0 ? -1 : 1) : 0;
  out.torqueAvailable = (useX ? torqueX : 0) + (useY ? torqueY : 0);
  const pitch = ROTATION_ACTIONS[0]![x < 0 ? 1 : 0];
  const yaw = ROTATION_ACTIONS[1]![y < 0 ? 1 : 0];
  // Written in place: an emptied list releases its memory, and this one is filled again in the next frame.
  out.actions[0] = xFirst ? pitch : yaw;
  if (useX && useY) out.actions[1] = xFirst ? yaw : pitch;
  else if (out.actions.length > 1) out.actions.pop();
}

/** DYNAMICS, actuators: wheel + RCS, RCS only while there is fuel. */
function writeAvailableTorque(out: Float64Array, { shipClass, fuel }: ShipView): void {
  for (let axis = 0; axis < 2; axis++)
    out[axis] = shipClass.reactionWheelTorque[axis]! + (fuel > 0 ? shipClass.rcsTorque[axis]! : 0);
}

const torque = new Float64Array(2);

/** A thruster that pushes up takes weight off the feet; so does burning fuel. */
function chooseHelp(out: Righting, surface: Surface, ship: ShipView): void {
  out.help = 'none';
  out.helpAction = '';
  out.helpMass = NaN;
  if (out.possible) return;
  const h = ship.groundContactOffset;
  let lift = 0;
  for (let k = 0; k < 3; k++) {
    const part = ship.shipClass.rcsThrust[k]! * Math.abs(surface.normalInShip[k]!);
    if (part <= lift || ship.fuel <= 0) continue;
    lift = part;
    out.helpAction = TRANSLATION_ACTIONS[k]![surface.normalInShip[k]! > 0 ? 0 : 1];
  }
  if (out.torqueAvailable > (surface.weight - lift) * h) {
    out.help = 'translation';
    return;
  }
  out.helpAction = '';
  const lightEnough = out.torqueAvailable / (surface.gravity * h);
  if (lightEnough <= ship.shipClass.dryMass) return;
  out.help = 'lighter';
  out.helpMass = lightEnough;
}
