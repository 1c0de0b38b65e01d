import type {
  Body,
  BodyMotion,
  Controls,
  Quat,
  Settings,
  ShipClass,
  ShipEventName,
  SurfaceState,
  Vec3,
} from '../dynamics';

/**
 * A trajectory to agree with: test/parity/fixtures/README.md describes the file. SI units, ICRF axes, quaternions [x, y, z, w];
 * one ship, one body.
 */
export interface Fixture {
  readonly name: string;
  readonly about: string;
  /** Game seconds. */
  readonly tickSeconds: number;
  readonly substepsPerTick: number;
  readonly terrain: FixtureTerrain;
  /** Settings that differ from the defaults. */
  readonly config: Partial<Settings>;
  readonly shipClass: ShipClass;
  /** At the initial tick. */
  readonly body: Body & BodyMotion;
  readonly initial: FixtureState;
  readonly inputs: readonly FixtureInput[];
  /** After the tick they name, in its order. */
  readonly states: readonly FixtureState[];
  readonly events: readonly FixtureEvent[];
}

/** Metres above the body's radius along n, unit, in the body's axes: base + amplitude (n · axis)²; or a terrain by name. */
export type FixtureTerrain =
  { readonly base: number; readonly amplitude: number; readonly axis: Vec3 } | { readonly name: string };

export interface FixtureState {
  readonly tick: number;
  readonly relativePosition: Vec3;
  readonly relativeVelocity: Vec3;
  readonly attitude: Quat;
  readonly angularVelocity: Vec3;
  /** kg */
  readonly fuel: number;
  readonly surfaceContactState: SurfaceState;
  readonly landedBodyName: string;
  /** m/s */
  readonly impactSpeed: number;
  readonly crashed: boolean;
}

/** Holds from the start of `substep` of the interval that begins at `tick`; absent fields keep their value. */
export interface FixtureInput {
  readonly tick: number;
  readonly substep: number;
  readonly controls: Partial<Controls>;
}

/** With the tick it led to: that of the boundary at the end of its interval. */
export interface FixtureEvent {
  readonly tick: number;
  readonly event: ShipEventName;
}
