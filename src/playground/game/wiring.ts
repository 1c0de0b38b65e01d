import { createGoalPanel } from '../panels/goal';
import { createLazyDock } from '../panels/workshop/lazyDock';
import { createMissionCard } from '../panels/missionCard';
import { createPanel, type Panel } from '../panels/panel';
import { createCarry } from '../input/carry';
import { connectDevices, type Devices } from '../input/devices';
import { createPageView, type PageView, takeDrops } from '../view/pageView';
import { watchSize } from '../view/pageSize';
import { type Acts, createActs } from './actions';
import { createCameraSwitch } from '../view/cameraSwitch';
import { createChooser } from './chooser';
import { keyCapOf, wireCockpit } from './words/controlWords';
import type { FlightLink } from './flightLink';
import { createLive, type Live } from './live';
import { createMissionGame, type MissionGame } from './mission/missionGame';
import type { Page } from './pageParts';
import type { Parts } from './parts';
import { wireFrames } from './showing';

const WORKSHOP_FAILED = 'The workshop did not load. Check the network and open it again.';

/** Creates the parts and connects them. */
export function wirePage(page: Page): Parts {
  const parts = {} as Parts;
  parts.live = wireLive(page, parts);
  parts.scene = wireScene(page, parts);
  parts.dock = createLazyDock(page.part('dock'), parts.scene.listeners, () =>
    page.notice.tell(WORKSHOP_FAILED),
  );
  parts.chooser = createChooser(page, parts);
  parts.panel = wirePanel(page, parts);
  parts.sound = null;
  parts.carry =
    page.stage === null
      ? null
      : createCarry(page.stage, (offset, begins) => parts.live.operate({ kind: 'carry', offset, begins }));
  parts.flightLink = wireFlightLink(page, parts);
  parts.acts = wireActs(page, parts);
  parts.devices = wireDevices(page, parts);
  parts.game = wireGame(page, parts);
  parts.cockpit = wireCockpit(page, parts);
  parts.loop = wireFrames(page, parts);
  takeDrops(page.document.body, parts.scene.load);
  watchSize(page.window, page.canvas, () => parts.loop.resized());
  return parts;
}

function wireLive({ program, banner, notice }: Page, parts: Parts): Live {
  return createLive(program, {
    onState: banner.state,
    onRefused: (reason) => notice.tell(`The server refused: ${reason}.`),
    onLost: ({ name, body }) => notice.tell(`Your ship ${name} was destroyed at ${body}.`),
    onEvent: () => undefined,
    onWorld(plan) {
      parts.scene.recorder.begin(plan);
      parts.dock.clear();
      parts.cockpit.forget();
      parts.game.begin();
    },
    onEntry: (entry) => parts.scene.recorder.take(entry),
    onRun(inputs) {
      if (!parts.flightLink.take(inputs)) parts.game.onRun(inputs);
    },
    onScenario: (scenario, terrain) => parts.chooser.follow(scenario, terrain),
  });
}

function wireScene({ query, notice, banner }: Page, parts: Parts): PageView {
  return createPageView({
    panel: () => parts.dock.recording,
    note: query,
    tell: notice.tell,
    banner: banner.state,
    changed(on) {
      parts.cockpit.forget();
      parts.live.hold(on);
      parts.dock.clear();
    },
  });
}

function wirePanel({ part, document, choices, notice }: Page, parts: Parts): Panel {
  const showDock = (open: boolean) => {
    document.body.classList.toggle('workshop', open);
    if (open) parts.dock.load();
  };
  const isMission = parts.chooser.isMission(choices.scenario);
  showDock(!isMission);
  const panel = createPanel(
    part('panel'),
    { workshopOpen: !isMission },
    {
      change: (name, text) => parts.chooser.change(name, text),
      act: (act) => parts.acts.act(act),
      workshop: showDock,
      failed: () => notice.tell(WORKSHOP_FAILED),
    },
  );
  panel.press('sound', false);
  return panel;
}

function wireActs(page: Page, parts: Parts): Acts {
  const { banner, choices, document, stage } = page;
  return createActs({
    live: parts.live,
    panel: parts.panel,
    banner,
    choices: () => choices,
    choose: parts.chooser.choose,
    begin: parts.chooser.beginAnew,
    help: parts.chooser.openHelp,
    resetCamera: () => stage?.resetCamera(),
    nextCamera: createCameraSwitch(stage, banner),
    copyLink: () => copyLink(page, parts),
    copyFlight: () =>
      parts.scene.deck.recording() === null ? parts.flightLink.copy() : copyLink(page, parts),
    toggleCarry: () => parts.carry?.toggle() ?? false,
    invite: parts.chooser.invite,
    toggleBare: () => document.body.classList.toggle('bare'),
    toggleAids: () => banner.flash(`Landing aids ${parts.cockpit.toggleAids() ? 'on' : 'off'}.`),
    toggleSound: () => void toggleSound(page, parts),
    deck: parts.scene.deck,
    meddled: (how) => parts.game.meddled(how),
  });
}

/** The code of flight links is loaded with the first one. */
function wireFlightLink({ choices, address, notice }: Page, parts: Parts): FlightLink {
  let link: FlightLink | null = null;
  const use = (act: (loaded: FlightLink) => void) => {
    import('./flightLink').then(
      ({ createFlightLink }) =>
        act((link ??= createFlightLink({ live: () => parts.live, choices: () => choices, address, notice }))),
      () => notice.tell('Part of the page did not load. Check the network and try again.'),
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
  const recording = parts.scene.deck.recording();
  if (recording === null) address.copy(query(), 'Link copied.');
  else parts.flightLink.copyOf(recording);
}

async function toggleSound({ window, banner, notice }: Page, parts: Parts): Promise<void> {
  try {
    parts.sound ??= (await import('../sound/sound')).createSound(window);
  } catch {
    notice.tell('The sound did not load. Check the network and press the key again.');
    return;
  }
  const isOn = parts.sound.set(!parts.sound.isOn()) && parts.sound.isOn();
  parts.panel.press('sound', isOn);
  banner.flash(isOn ? 'Sound on.' : 'Sound off.');
}

function wireDevices(page: Page, parts: Parts): Devices {
  const { hands, steer } = parts.live;
  const isReplaying = () => parts.scene.deck.replay() !== null;
  return connectDevices(page.window, {
    settings: () => page.keys,
    stick: hands.stick,
    pressed: parts.acts.press,
    released: parts.acts.release,
    confirmed: () => parts.game.confirm(),
    letGo() {
      hands.letGo();
      steer();
    },
    lever(throttle) {
      if (isReplaying()) return;
      hands.setThrottle(throttle);
      steer();
    },
    moved() {
      if (isReplaying()) return;
      hands.deflect();
      steer();
    },
    changed: () => parts.game.reword(),
    tell: page.banner.flash,
    isResting: () => hands.isResting() || isReplaying(),
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
    resetCamera: () => page.stage?.resetCamera(),
  });
}
