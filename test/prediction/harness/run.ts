import { createDice } from './random';
import { type Fault, FAULTS } from './faults';
import { createPage, type Page } from './page';
import { drawSetup } from './setup';
import { type Watch, watchPage } from './watch';

/** A run that was made, with one fault in it. */
export interface Run {
  readonly page: Page;
  readonly watch: Watch;
  readonly fault: Fault;
  /** True s from the start at which the fault began and ended. */
  readonly from: number;
  readonly over: number;
  /** s from one send to the next. */
  readonly send: number;
  readonly label: string;
}

/** Undisturbed before the fault, and watched after it: s, and sends. */
const BEFORE = { seconds: 8, sends: 4 };
const AFTER = { seconds: 12, sends: 5 };

/** Draws world, network, page and fault from the seed, and runs them. Throws what the library throws. */
export function runSeed(seed: number): Run {
  const dice = createDice(seed);
  const setup = drawSetup(dice);
  const page = createPage(setup, dice);
  const watch = watchPage(page);
  const send = 1 / setup.server.options.sendRate;
  const fault: Fault = dice.pick(FAULTS);
  const during = (seconds: number) => {
    page.run(seconds, watch.each);
  };
  during(Math.max(BEFORE.seconds, BEFORE.sends * send));
  const from = page.t;
  fault.happen(page, dice, during);
  const over = page.t;
  during(Math.max(AFTER.seconds, AFTER.sends * send));
  // The truth of what was drawn ahead.
  setup.server.runTo(page.t + 2 * send, () => undefined);
  const label = `seed ${seed}: ${fault.name} for ${(over - from).toFixed(1)} s; ${setup.label}`;
  return { page, watch, fault, from, over, send, label };
}
