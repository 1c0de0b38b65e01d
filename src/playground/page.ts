import { TERRAINS } from '../dynamics';
import { createCockpitLandingHud, createFleetHud } from '../hud';
import type { WorldView } from '../prediction';
import {
  createFleetReadout,
  createLandingReadout,
  updateFleetReadout,
  updateLandingReadout,
} from '../readout';
import { FINE, qualityFor } from '../scene';
import { SCENARIOS } from '../scenarios';
import { createActs } from './game/actions';
import { type Choices, OVERLAY_NAMES, readChoices, setChoice, writeChoices } from './panels/choices';
import { createDock } from './panels/dock';
import { openStage, watchContext } from './view/graphics';
import type { Help } from './panels/help';
import { listenToKeys } from './input/keyboard';
import { keyCap, loadKeys, saveKeys } from './input/keyTable';
import { createLive, networkOf } from './game/live';
import { createNotice } from './panels/notice';
import { keepForOffline } from './offline/keep';
import { createPads } from './input/pads';
import { createPanel } from './panels/panel';
import { steerCamera } from './input/pointer';
import { createResolution } from './view/resolution';
import { createTheatre, takeDrops } from './view/pageView';
import { createTwin } from './game/textTwin';

/** Choices that change a running world; the others begin a new one. */
const LIVE_CHOICES: readonly (keyof Choices)[] = [
  'mode',
  'overlays',
  'slow',
  'network',
  'delay',
  'jitter',
  'stalled',
  'stall',
];

/** CSS pixels of width below which no picture is drawn coarser. */
const SHARP = 600;

/** Said from the page's opening until its first picture, where nothing else is to be said. */
const BUILDING = 'Building the ground …';

/** The playground: wires hands, server, predictor, HUDs and picture together. `program`: address of the main module. */
export function begin(document: Document, program: string): void {
  const window = document.defaultView!;
  const part = (id: string) => document.getElementById(id)!;
  const root = document.documentElement;
  const canvas = part('stage') as HTMLCanvasElement;
  const notice = createNotice(part('notice'));
  const query = new URLSearchParams(window.location.search);
  const { choices, complaints } = readChoices(query);
  const freezeAt = Number(query.get('freeze') ?? NaN);
  if (complaints.length > 0)
    notice.tell(`The link asks for what cannot be had; the rest of it holds.\n${complaints.join('\n')}`);
  const store = storeOf(window);
  let keys = loadKeys(store);
  let said = '';
  const banner = (text: string) => {
    said = text;
    const shown = said === '' && !isWarm && stage !== null ? BUILDING : said;
    if (part('banner').textContent !== shown) part('banner').textContent = shown;
  };

  const isFine = choices.picture === 'fine';
  const stage = openStage(canvas, isFine ? FINE : qualityFor(document), notice.tell);
  const live = createLive(program, {
    onState: banner,
    onRefused: (reason) => notice.tell(`The server refused: ${reason}.`),
    onEvent: () => undefined,
    onWorld(plan) {
      theatre.recorder.begin(plan);
      dock.clear();
      landing = createLandingReadout();
    },
    onEntry: (entry) => theatre.recorder.take(entry),
  });
  let landing = createLandingReadout();
  const fleet = createFleetReadout();
  let generation = 0;
  let before = NaN;
  /** The first picture builds the ground and compiles its programs, a second or more: the show then begins again, whole. */
  let isWarm = false;
  let isBuilding = false;
  let isResized = false;
  const landingHud = createCockpitLandingHud(document, part('hud'), {
    theme: 'system',
    keyLabel: (action) => (keys.enabled ? keyCap(keys.map[action]) : ''),
  });
  const fleetHud = createFleetHud(document, part('hud'), { theme: 'system' });
  const twin = createTwin(part('twin'));
  const resolution = createResolution();
  const theatre = createTheatre({
    panel: () => dock.recording,
    note: () => writeChoices(choices),
    tell: notice.tell,
    banner,
    changed(on) {
      landing = createLandingReadout();
      live.hold(on);
      dock.clear();
    },
  });
  const dock = createDock(part('dock'), theatre.listeners);
  takeDrops(document.body, theatre.load);
  const panel = createPanel(part('panel'), { change, act: (act) => acts.act(act) });
  let help: Promise<Help> | null = null;
  const acts = createActs({
    live,
    panel,
    choices: () => choices,
    choose: (name, text) => {
      change(name, text);
      panel.show(choices);
    },
    begin: beginAnew,
    help: openHelp,
    resetCamera: () => stage?.resetCamera(),
    copyLink,
    banner,
    toggleBare: () => document.body.classList.toggle('bare'),
  });

  listenToKeys(window, () => keys, {
    pressed: acts.press,
    released: acts.release,
    letGo: () => live.stick.held.clear(),
  });
  createPads(part('pads'), acts.press, acts.release);
  if (stage !== null) {
    steerCamera(canvas, stage);
    watchContext(canvas, notice, () => (isResized = true));
  }
  new window.ResizeObserver(() => (isResized = true)).observe(canvas);
  fit();
  panel.show(choices);
  banner('');
  beginWorld();
  window.requestAnimationFrame(frame);

  /** The dialog is fetched when it is first asked for. */
  function openHelp(): void {
    help ??= import('./panels/help').then(({ createHelp }) =>
      createHelp(
        document,
        () => keys,
        (next) => saveKeys(store, (keys = next)),
      ),
    );
    help.then(
      ({ open }) => open(),
      () => {
        help = null;
        notice.tell('The list of keys could not be fetched. Is the network off? Press the key again.');
      },
    );
  }

  function change(name: keyof Choices, text: string): string | null {
    const reason = setChoice(choices, name, text);
    if (reason !== null) return reason;
    if (LIVE_CHOICES.includes(name)) applyLive(name);
    else beginAnew();
    window.history.replaceState(null, '', writeChoices(choices) || window.location.pathname);
    panel.show(choices);
    return null;
  }

  function applyLive(name: keyof Choices): void {
    if (name === 'slow') live.setSpeed(choices.slow);
    else if (name !== 'mode' && name !== 'overlays')
      live.operate({ kind: 'network', numbers: networkOf(choices) });
    showOverlays();
  }

  function showOverlays(): void {
    if (stage !== null)
      for (const name of OVERLAY_NAMES) stage.overlays[name] = choices.overlays.includes(name);
  }

  /** What was said of the world before goes; what the link and the browser lack is said before there is one. */
  function beginAnew(): void {
    notice.clear();
    beginWorld();
  }

  function beginWorld(): void {
    theatre.leave();
    acts.reset();
    const scenario = SCENARIOS.find(({ name }) => name === choices.scenario)!;
    const terrain = choices.terrain === '' ? scenario.terrain : choices.terrain;
    stage?.setTerrain(TERRAINS[terrain]!);
    showOverlays();
    live.begin(choices);
  }

  function copyLink(): void {
    const link = window.location.origin + window.location.pathname + writeChoices(choices);
    window.navigator.clipboard.writeText(link).then(
      () => banner('The link is on the clipboard.'),
      () => notice.tell(`The clipboard cannot be had; the link is:\n${link}`),
    );
  }

  /** Device pixels a CSS pixel; a small picture is no gain when coarser. */
  function pixelRatio(width: number): number {
    const share = Math.max(resolution.share(), Math.min(SHARP / width, 1));
    return Math.min(window.devicePixelRatio, 2) * share;
  }

  function fit(): void {
    isResized = false;
    const { clientWidth, clientHeight } = canvas;
    if (clientWidth > 0 && clientHeight > 0)
      stage?.resize(clientWidth, clientHeight, pixelRatio(clientWidth));
  }

  function frame(milliseconds: number): void {
    const frozen = root.dataset['frozen'] === 'true';
    if (!frozen) window.requestAnimationFrame(frame);
    acts.tick(milliseconds / 1000);
    const now = live.clock.now();
    const passed = Number.isNaN(before) ? 0 : now - before;
    before = now;
    const replayed = theatre.frame(passed);
    const view = replayed ?? live.frame();
    const replay = theatre.replay();
    if (replay !== null && replay.generation() !== generation) {
      generation = replay.generation();
      landing = createLandingReadout();
    }
    landingHud.paint(updateLandingReadout(landing, view));
    fleetHud.paint(updateFleetReadout(fleet, view));
    twin.tell(view, landing, now);
    (replay?.baseline ?? live.baseline).redraw(view, choices.mode, replay?.position() ?? now);
    dock.follow(view, now);
    // Before the picture: a canvas that changes size is blank until it is drawn again.
    // Frames in which nothing is drawn tell nothing of the machine.
    const isMeasured = view.ready && !isFine && Number.isNaN(freezeAt);
    const hasChanged = isMeasured && resolution.measure(milliseconds / 1000);
    if (hasChanged || isResized) fit();
    if (view.ready && (isWarm || !isBuilding)) stage?.draw(view, now);
    if (view.ready && !isWarm) {
      isBuilding = true;
      isWarm = stage === null || stage.hasDrawn();
      if (!isWarm) return;
      banner(said);
      keepForOffline(window, () => (root.dataset['offline'] = 'kept'));
      if (stage !== null && choices.server === '') {
        beginWorld();
        return;
      }
    }
    report(view);
  }

  /** What the page shows, for tests and screenshots: on the root element, nowhere else. */
  function report(view: WorldView): void {
    const { dataset } = root;
    const own = view.own;
    const status = own === null ? '' : own.shownState === '' ? 'flight' : own.shownState;
    if (dataset['status'] !== status) dataset['status'] = status;
    const provenance = own?.provenance ?? '';
    if (dataset['provenance'] !== provenance) dataset['provenance'] = provenance;
    const run = live.hash();
    if (dataset['run'] !== run) {
      dataset['run'] = run;
      panel.showRun(
        run === '' ? '' : `Own ship at tick ${run.replace(':', ', bits ')}${live.ended() ? ' (end)' : ''}`,
      );
    }
    if (!view.ready) return;
    const seconds = (view.tick * view.timeScale) / view.tickRate + view.sinceTick;
    if (seconds >= freezeAt) dataset['frozen'] = 'true';
    if (Number.isNaN(freezeAt) || seconds >= freezeAt) dataset['ready'] = 'true';
  }
}

/** The page's own store; a browser may forbid even asking for it. */
function storeOf(window: Window): Storage | null {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}
