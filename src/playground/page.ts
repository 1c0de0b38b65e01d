import { FINE, qualityFor } from '../scene';
import { createAddress } from './game/address';
import { createBestRuns, readRace } from './game/mission/bestRuns';
import { readChoices, writeChoices } from './panels/choices';
import { createBanner } from './panels/banner';
import { createNotice } from './panels/notice';
import { loadKeys } from './input/keyTable';
import type { Page } from './game/pageParts';
import { wirePage } from './game/wiring';
import { openSceneView, watchContext } from './view/graphics';
import { createResolution } from './view/resolution';
import { steerCamera } from './input/pointer';

/** Said from the page's opening until its first picture, where nothing else is to be said. */
const BUILDING = 'Building the ground …';

/** The playground: wires hands, server, predictor, HUDs and picture together. `program`: address of the main module. */
export function begin(document: Document, program: string): void {
  const window = document.defaultView!;
  const part = (id: string) => document.getElementById(id)!;
  const canvas = part('stage') as HTMLCanvasElement;
  const notice = createNotice(part('notice'));
  const banner = createBanner(part('banner'));
  const query = new URLSearchParams(window.location.search);
  const { choices, complaints } = readChoices(query);
  const race = readRace(query);
  const wrong = [...complaints, ...(typeof race === 'string' ? [race] : [])];
  if (wrong.length > 0)
    notice.tell(`Some values in this link are invalid and were ignored.\n${wrong.join('\n')}`);
  const store = storeOf(window);
  const isFine = choices.picture === 'fine';
  const stage = openSceneView(canvas, isFine ? FINE : qualityFor(document), notice.tell);
  const page: Page = {
    document,
    window,
    program,
    part,
    canvas,
    stage,
    notice,
    banner,
    choices,
    store,
    keys: loadKeys(store),
    address: createAddress(window, banner, notice),
    best: createBestRuns(store),
    resolution: isFine ? null : createResolution(),
    query: () => writeChoices(choices),
  };
  const parts = wirePage(page);
  if (stage !== null) {
    steerCamera(canvas, stage, parts.carry!);
    watchContext(canvas, notice, parts.loop.resized);
    banner.rest(BUILDING);
  }
  if (race !== null && typeof race !== 'string') {
    parts.game.race(race);
    notice.tell(
      `Race ${race.by}: ${race.score.total} points in ${race.outcome.seconds.toFixed(0)} s. Their ship flies beside yours.`,
    );
  }
  parts.panel.show(choices);
  parts.loop.resized();
  parts.chooser.beginWorld();
  parts.loop.start();
}

/** The page's own store; a browser may forbid even asking for it. */
function storeOf(window: Window): Storage | null {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}
