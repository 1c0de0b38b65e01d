import type { Scenario } from '../scenario';

/** A landing pad: its position east and north of the mission's site, m, and its radius, m. */
export interface Pad {
  readonly east: number;
  readonly north: number;
  readonly radius: number;
}

/** When a mission is complete. */
export type MissionGoal =
  /** Landed on every pad, in order. */
  | { readonly kind: 'land' }
  /** Feet between two heights, m, for a number of game seconds. */
  | { readonly kind: 'hover'; readonly low: number; readonly high: number; readonly seconds: number }
  /** In flight over the pad, below a height, m, and slower than `speed`, m/s. */
  | { readonly kind: 'reach'; readonly below: number; readonly speed: number };

/** A task for a pilot as data: a scenario to start from, pads and a goal. */
export interface Mission {
  readonly scenario: Scenario;
  /** One sentence: what to do. */
  readonly goal: string;
  /** Instructions of a lesson; '' in a mission. Keys are named in braces by their action: {throttleUp}. */
  readonly how: string;
  readonly done: MissionGoal;
  readonly pads: readonly Pad[];
  /** A lesson of the flight school, which is not scored. */
  readonly isLesson: boolean;
  /** Flown on instruments: the picture is nearly dark. */
  readonly night: boolean;
  /** Largest touch speed that meets the goal, m/s; absent if the goal names none. */
  readonly touchLimit?: number;
  /** Slope of the ground at the pads, degrees, which a ship's tilt against the vertical includes; 0 if absent. */
  readonly slope?: number;
  /** Game seconds and kg of fuel that earn full points. */
  readonly parSeconds: number;
  readonly parFuel: number;
}
