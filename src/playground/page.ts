import { FINE, qualityFor } from '../scene';
import { createAddress } from './game/address';
import { GHOST_SHIP } from './game/mission/ghost';
import { createRuns } from './game/mission/runs';
import { readChoices, writeChoices } from './panels/choices';
import { createBanner } from './panels/banner';
import { createNotice } from './panels/notice';
import { loadKeys } from './input/keyTable';
import type { Page } from './game/pageParts';
import type { Parts } from './game/parts';
import { wirePage } from './game/wiring';
import { openSceneView, watchContext } from './view/graphics';
import { watchMargins } from './view/margins';
import { createResolution } from './view/resolution';
import { startWorker } from './server/connection';
import { steerCamera } from './input/pointer';

/** Shown from the page's opening until its first picture, unless there is another message. */
const BUILDING = 'Building the ground …';

/** The playground: connects controls, server, predictor, HUDs and scene. `program`: address of the main module. */
export function begin(document: Document, program: string): void {
  const window = document.defaultView!;
  const part = (id: string) => document.getElementById(id)!;
  const canvas = part('scene-view') as HTMLCanvasElement;
  const notice = createNotice(part('notice'));
  const banner = createBanner(part('banner'));
  const query = new URLSearchParams(window.location.search);
  const { choices, complaints } = readChoices(query);
  if (complaints.length > 0) notice.show(invalidText(complaints));
  const store = storeOf(window);
  // Before the scene: while that is created, the worker loads.
  const worker = choices.server === '' ? startWorker(program, () => undefined) : null;
  const isFine = choices.picture === 'fine';
  const sceneView = openSceneView(canvas, isFine ? FINE : qualityFor(document), notice.show);
  sceneView?.translucent.add(GHOST_SHIP);
  const page: Page = {
    document,
    window,
    program,
    worker,
    part,
    canvas,
    sceneView,
    notice,
    banner,
    choices,
    store,
    keys: loadKeys(store),
    address: createAddress(window, banner, notice),
    runs: createRuns(store),
    resolution: isFine ? null : createResolution(),
    query: () => writeChoices(choices),
  };
  const parts = wirePage(page);
  if (sceneView !== null) {
    steerCamera(canvas, sceneView, parts.shipDrag!);
    watchContext(canvas, notice, parts.loop.resized);
    watchMargins(window, part, sceneView);
    banner.rest(BUILDING);
  }
  parts.panel.show(choices);
  parts.loop.resized();
  parts.chooser.beginWorld();
  parts.loop.start();
  if (query.has('run')) void joinRace(query, page, parts);
}

function invalidText(complaints: readonly string[]): string {
  return `Some values in this link are invalid and were ignored.\n${complaints.join('\n')}`;
}

/** A friend's run in the address: flown again, and raced. */
async function joinRace(query: URLSearchParams, { runs, notice }: Page, { game }: Parts): Promise<void> {
  const loaded = await runs.load().catch(() => null);
  const race = loaded?.module.readRace(query) ?? 'run: part of the page did not load';
  if (typeof race === 'string') {
    notice.show(invalidText([race]));
    return;
  }
  game.race(race);
  const seconds = race.outcome.seconds.toFixed(0);
  notice.tell(`Race ${race.by}: ${race.score.total} points in ${seconds} s. Their ghost flies beside you.`);
}

/** The page's storage; a browser may forbid even access to it. */
function storeOf(window: Window): Storage | null {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}
