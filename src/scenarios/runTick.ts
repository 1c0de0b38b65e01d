import {
  beginTick,
  type Controls,
  endTick,
  stepWorld,
  type Timing,
  type World,
  writeControls,
} from '../dynamics';

/** A world of one ship and one body at a tick boundary. */
export interface ScenarioWorld {
  readonly world: World;
  /** Rows of the ship and of the body. */
  readonly ship: Float64Array;
  readonly bodies: Float64Array;
}

/** Full controls from the start of a substep. */
export interface ScheduledInput {
  readonly tick: number;
  readonly substep: number;
  readonly controls: Controls;
}

/** The controls that come into force at a substep, or null. Asked once for each substep, in order. */
export type Schedule = (tick: number, substep: number) => Controls | null;

/** How a tick is run, and its callbacks. */
export interface TickRun {
  readonly timing: Timing;
  readonly schedule: Schedule;
  /** Called before each substep, with the controls in force. */
  readonly before?: (substep: number) => void;
  /** Called after each substep, with its event: one of EVENT_NAMES, or NO_EVENT. */
  readonly after?: (event: number, substep: number) => void;
}

/** @param inputs ascending in time */
export function scheduleOf(inputs: readonly ScheduledInput[]): Schedule {
  let next = 0;
  return (tick, substep) => {
    let controls: Controls | null = null;
    for (; next < inputs.length; next++) {
      const input = inputs[next]!;
      if (input.tick > tick || (input.tick === tick && input.substep > substep)) break;
      ({ controls } = input);
    }
    return controls;
  };
}

/** Runs the interval that begins at `tick` on the dynamics alone. */
export function runTick({ world, ship, bodies }: ScenarioWorld, tick: number, run: TickRun): void {
  const { timing, schedule, before, after } = run;
  const reported = new Uint8Array(1);
  beginTick(ship, bodies, world);
  for (let substep = 0; substep < timing.substeps; substep++) {
    const controls = schedule(tick, substep);
    if (controls !== null) writeControls(ship, 0, controls);
    before?.(substep);
    stepWorld(ship, bodies, reported, world, timing.dt);
    after?.(reported[0]!, substep);
  }
  endTick(bodies, world, timing);
}
