import type { Page } from './page';
import type { Dice } from './random';
import { OTHER, OWN, placeShip, TICK_RATES } from './setup';
import { conjugate, minus, turned, unit } from './design/vectors';

/** Something that goes wrong; it returns when it is over. `each` sees the display frames meanwhile. */
export interface Fault {
  readonly name: string;
  readonly happen: (page: Page, dice: Dice, during: (seconds: number) => void) => void;
}

const seconds = (dice: Dice) => (dice.chance(0.05) ? dice.logBetween(60, 600) : dice.logBetween(0.3, 40));

export const FAULTS: readonly Fault[] = [
  {
    name: 'way down held',
    happen: (page, dice, during) => {
      const long = seconds(dice);
      page.down.hold(page.t + long);
      during(long);
    },
  },
  {
    name: 'way up held',
    happen: (page, dice, during) => {
      const long = seconds(dice);
      page.up.hold(page.t + long);
      during(long);
    },
  },
  {
    name: 'both ways held',
    happen: (page, dice, during) => {
      const long = seconds(dice);
      page.down.hold(page.t + long);
      page.up.hold(page.t + long);
      during(long);
    },
  },
  {
    name: 'bursts',
    happen: (page, dice, during) => {
      for (let k = 0; k < 6; k++) {
        const long = dice.between(0.1, 0.9);
        page.down.hold(page.t + long);
        if (dice.chance(0.5)) page.up.hold(page.t + long);
        during(long + dice.between(0.05, 0.4));
      }
    },
  },
  {
    name: 'duplicates',
    happen: (page, dice, during) => {
      page.down.duplicates = { share: 0.5, within: dice.pick([0.01, 0.3]) };
      during(dice.between(2, 10));
      page.down.duplicates = { share: 0, within: 0 };
    },
  },
  {
    name: 'reconnect, out of order',
    happen: (page, dice, during) => {
      for (let k = 0; k < 3; k++) {
        page.down.hold(page.t + dice.between(0, 1));
        during(dice.between(0.2, 1.2));
        page.down.reconnect(page.t);
      }
      during(1);
    },
  },
  {
    name: 'page frozen',
    happen: (page, dice) => {
      page.freeze(seconds(dice));
    },
  },
  {
    name: 'now put on',
    happen: (page, dice) => {
      page.shift += seconds(dice);
    },
  },
  {
    name: 'now put back',
    happen: (page, dice) => {
      page.shift -= seconds(dice);
    },
  },
  {
    name: 'server stands',
    happen: (page, dice, during) => {
      const long = seconds(dice);
      page.setup.server.stand(page.t, long);
      during(long);
    },
  },
  {
    name: 'server restarts at 0',
    happen: (page, dice, during) => {
      const down = dice.logBetween(0.05, 10);
      page.setup.server.stand(page.t, down + 1);
      during(down);
      respawn(page, dice, OWN);
      page.setup.server.restart(page.t, 0);
    },
  },
  {
    name: 'server restarts further on',
    happen: (page, dice, during) => {
      const down = dice.logBetween(0.05, 10);
      page.setup.server.stand(page.t, down + 1);
      during(down);
      page.setup.server.restart(page.t, 900_000);
    },
  },
  {
    name: 'the player changes ship',
    happen: (page) => {
      page.ownShip = page.ownShip === OWN ? OTHER : OWN;
      page.predictor.setOwnShip(page.ownShip);
      page.presses.length = 0;
    },
  },
  {
    name: 'spectator for a while',
    happen: (page, _, during) => {
      const before = page.ownShip;
      page.ownShip = null;
      page.predictor.setOwnShip(null);
      during(2);
      page.ownShip = before;
      page.predictor.setOwnShip(before);
    },
  },
  {
    name: 'other ship removed, told',
    happen: (page) => {
      page.setup.server.ships.delete(OTHER);
      page.predictor.removeShip(OTHER, 'gone');
    },
  },
  {
    name: 'other ship removed, not told',
    happen: (page) => {
      page.setup.server.ships.delete(OTHER);
    },
  },
  {
    name: 'teleported, told',
    happen: (page, dice) => {
      respawn(page, dice, OWN);
      page.predictor.teleported(OWN);
    },
  },
  {
    name: 'teleported, not told',
    happen: (page, dice) => {
      respawn(page, dice, OWN);
    },
  },
  {
    name: 'tick rate changed',
    happen: (page, dice) => {
      const { options } = page.setup.server;
      options.tickRate = dice.pick(TICK_RATES.filter((rate) => rate !== options.tickRate));
    },
  },
  {
    name: 'time scale changed',
    happen: (page, dice) => {
      const { options } = page.setup.server;
      options.timeScale = dice.pick(options.tickRate === 100 ? [0.1, 0.5, 2] : [0.1, 0.5]);
    },
  },
];

/** Somewhere else near by, coming down. */
function respawn(page: Page, dice: Dice, id: string): void {
  const { server } = page.setup;
  const { body, ships } = server;
  const { terrainHeight } = server.options;
  const ship = ships.get(id);
  if (ship === undefined) return;
  const site = unit(turned(conjugate(body.attitude), minus(ship.position, body.position)));
  const { shipClass } = ship;
  ships.set(id, placeShip(dice, { id, shipClass, site, body, terrainHeight, aside: dice.between(100, 800) }));
}
