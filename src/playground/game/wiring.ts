import { createGoalPanel } from '../panels/goal';
import { createLazyDock } from '../panels/workshop/lazyDock';
import { createMissionCard } from '../panels/missionCard';
import { createPanel, type Panel } from '../panels/panel';
import { createShipDrag } from '../input/shipDrag';
import { connectDevices, type Devices } from '../input/devices';
import { createRecordingView, type RecordingView, takeDrops } from '../recording/recordingView';
import { watchSize } from '../view/pageSize';
import { type Actions, createActions } from './actions/actions';
import { createCameraSwitch } from '../view/cameraSwitch';
import { createChooser } from './chooser';
import { keyCapOf, wireCockpit } from './texts/controlTexts';
import { placeName } from './texts/placeName';
import type { FlightLink } from './flight/flightLink';
import { createLive, type Live } from './live/live';
import type { LiveListeners } from './live/liveState';
import { createMissionGame, type MissionGame } from './mission/missionGame';
import type { Page } from './pageParts';
import type { Parts } from './parts';
import { wireFrames } from './frames';

const WORKSHOP_FAILED = 'The workshop did not load. Check the network and open it again.';

/** Creates the parts and connects them. */
export function wirePage(page: Page): Parts {
  const parts = {} as Parts;
  parts.live = wireLive(page, parts);
  parts.recording = wireRecording(page, parts);
  parts.dock = createLazyDock(page.part('dock'), parts.recording.listeners, () =>
    page.notice.show(WORKSHOP_FAILED),
  );
  parts.chooser = createChooser(page, parts);
  parts.panel = wirePanel(page, parts);
  parts.sound = null;
  parts.shipDrag =
    page.sceneView === null
      ? null
      : createShipDrag(page.sceneView, (offset, begins) =>
          parts.live.operate({ kind: 'drag', offset, begins }),
        );
  parts.flightLink = wireFlightLink(page, parts);
  parts.actions = wireActions(page, parts);
  parts.devices = wireDevices(page, parts);
  parts.game = wireGame(page, parts);
  parts.cockpit = wireCockpit(page, parts);
  parts.loop = wireFrames(page, parts);
  takeDrops(page.document.body, parts.recording.load);
  watchSize(page.window, page.canvas, () => parts.loop.resized());
  return parts;
}

function wireLive({ program, worker, banner, notice }: Page, parts: Parts): Live {
  const listeners: LiveListeners = {
    onState: banner.state,
    onRefused: (reason) => notice.show(`The server refused: ${reason}.`),
    onLost: ({ name, body }) => notice.show(`Your ship ${name} was destroyed on ${placeName(body)}.`),
    onEvent: () => undefined,
    onWorld(plan) {
      parts.recording.recorder.begin(plan);
      parts.dock.clear();
      parts.cockpit.forget();
      parts.game.begin();
    },
    onEntry: (entry, bytes) => parts.recording.recorder.take(entry, bytes),
    onRun(inputs) {
      if (!parts.flightLink.take(inputs)) parts.game.onRun(inputs);
    },
    onScenario: (scenario, terrain) => parts.chooser.follow(scenario, terrain),
  };
  return createLive(program, listeners, worker);
}

function wireRecording({ query, notice, banner }: Page, parts: Parts): RecordingView {
  return createRecordingView({
    panel: () => parts.dock.recording,
    note: query,
    notify: notice.show,
    banner: banner.state,
    changed(on) {
      parts.cockpit.forget();
      parts.live.suspend(on);
      parts.dock.clear();
    },
  });
}

function wirePanel({ part, document, choices, notice }: Page, parts: Parts): Panel {
  const showDock = (open: boolean) => {
    document.body.classList.toggle('workshop', open);
    if (open) parts.dock.load();
  };
  const isGame = parts.chooser.isGame(choices.scenario);
  showDock(!isGame);
  const panel = createPanel(
    part('panel'),
    { workshopOpen: !isGame },
    {
      change: (name, text) => parts.chooser.change(name, text),
      action: (action) => parts.actions.runPanelAction(action),
      workshop: showDock,
      failed: () => notice.show(WORKSHOP_FAILED),
    },
  );
  panel.press('sound', false);
  return panel;
}

function wireActions(page: Page, parts: Parts): Actions {
  const { banner, choices, document, sceneView } = page;
  return createActions({
    live: parts.live,
    panel: parts.panel,
    banner,
    choices: () => choices,
    choose: parts.chooser.choose,
    begin: parts.chooser.beginAnew,
    help: parts.chooser.openHelp,
    resetCamera: () => sceneView?.resetCamera(),
    nextCamera: createCameraSwitch(sceneView, banner),
    copyLink: () => copyLink(page, parts),
    copyFlight: () =>
      parts.recording.deck.recording() === null ? parts.flightLink.copy() : copyLink(page, parts),
    toggleDrag: () => parts.shipDrag?.toggle() ?? false,
    invite: parts.chooser.invite,
    toggleBare: () => document.body.classList.toggle('bare'),
    toggleAids: () => banner.flash(`Landing aids ${parts.cockpit.toggleAids() ? 'on' : 'off'}.`),
    toggleSound: () => void toggleSound(page, parts),
    deck: parts.recording.deck,
    markIntervention: (how) => parts.game.markIntervention(how),
  });
}

/** The code of flight links is loaded with the first one. */
function wireFlightLink({ choices, address, notice }: Page, parts: Parts): FlightLink {
  let link: FlightLink | null = null;
  const use = (then: (loaded: FlightLink) => void) => {
    import('./flight/flightLink').then(
      ({ createFlightLink }) =>
        then(
          (link ??= createFlightLink({ live: () => parts.live, choices: () => choices, address, notice })),
        ),
      () => notice.show('Part of the page did not load. Check the network and try again.'),
    );
  };
  return {
    copy: () => use(({ copy }) => copy()),
    take: (inputs) => link?.take(inputs) ?? false,
    copyOf: (recording) => use(({ copyOf }) => copyOf(recording)),
  };
}

/** The world as it is chosen; while a recording plays, the flight that it holds. */
function copyLink({ address, query }: Page, parts: Parts): void {
  const recording = parts.recording.deck.recording();
  if (recording === null) address.copy(query(), 'Link copied.');
  else parts.flightLink.copyOf(recording);
}

async function toggleSound({ window, banner, notice }: Page, parts: Parts): Promise<void> {
  try {
    parts.sound ??= (await import('../sound/sound')).createSound(window);
  } catch {
    notice.show('The sound did not load. Check the network and press the key again.');
    return;
  }
  const isOn = parts.sound.set(!parts.sound.isOn()) && parts.sound.isOn();
  parts.panel.press('sound', isOn);
  banner.flash(isOn ? 'Sound on.' : 'Sound off.');
}

function wireDevices(page: Page, parts: Parts): Devices {
  const { flightControls, steer } = parts.live;
  const isReplaying = () => parts.recording.deck.replay() !== null;
  return connectDevices(page.window, {
    settings: () => page.keys,
    stick: flightControls.stick,
    pressed: parts.actions.press,
    released: parts.actions.release,
    confirmed: () => parts.game.confirm(),
    releaseAll() {
      flightControls.releaseAll();
      steer();
    },
    lever(throttle) {
      if (isReplaying()) return;
      flightControls.setThrottle(throttle);
      steer();
    },
    moved() {
      if (isReplaying()) return;
      flightControls.takeOver();
      steer();
    },
    changed: () => parts.game.reword(),
    notify: page.banner.flash,
    isPaused: () => flightControls.isPaused() || isReplaying(),
  });
}

function wireGame(page: Page, parts: Parts): MissionGame {
  const { choices, address, notice, runs, part } = page;
  return createMissionGame({
    live: parts.live,
    choices: () => choices,
    choose: parts.chooser.choose,
    restart: parts.chooser.beginAnew,
    goal: createGoalPanel(part('goal')),
    card: createMissionCard(part('card')),
    address,
    notice,
    runs,
    device: parts.devices.device,
    cap: keyCapOf(page, parts),
    resetCamera: () => page.sceneView?.resetCamera(),
    flash: page.banner.flash,
  });
}
