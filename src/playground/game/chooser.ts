import { TERRAINS } from '../../dynamics';
import { findMission, findScenario, FREE_FLIGHT } from '../../scenarios';
import { saveKeys } from '../input/keyTable';
import { type Choices, OVERLAY_NAMES, setChoice } from '../panels/choices';
import type { Help } from '../panels/help';
import { keyCapOf } from './texts/controlTexts';
import { networkOf, upNetworkOf } from './live/live';
import { TAB_ADDRESS } from '../server/tabAddress';
import type { Page } from './pageParts';
import type { Chooser, Parts } from './parts';

const NETWORK_CHOICES: readonly (keyof Choices)[] = [
  'network',
  'delay',
  'jitter',
  'stalled',
  'stall',
  'upDelay',
  'upJitter',
  'upStalled',
];
/** Choices that change a running world; the others begin a new one. */
const LIVE_CHOICES: readonly (keyof Choices)[] = ['mode', 'overlays', 'slow', 'pilot', ...NETWORK_CHOICES];

export function createChooser(page: Page, parts: Parts): Chooser {
  const { choices, sceneView, notice, address, query } = page;
  let room = '';
  const showOverlays = () => {
    if (sceneView !== null)
      for (const name of OVERLAY_NAMES) sceneView.overlays[name] = choices.overlays.includes(name);
  };
  const operateNetwork = () => {
    const up = upNetworkOf(choices);
    parts.live.operate({ kind: 'network', numbers: networkOf(choices), ...(up !== undefined && { up }) });
  };
  const applyLive = (name: keyof Choices) => {
    if (name === 'slow') {
      parts.live.setSpeed(choices.slow);
      if (choices.slow < 1) parts.game.markIntervention('it was flown in slow motion');
    } else if (NETWORK_CHOICES.includes(name)) operateNetwork();
    showOverlays();
  };
  const beginWorld = () => {
    parts.recording.leave();
    parts.actions.reset();
    const terrain = choices.terrain === '' ? findScenario(choices.scenario)!.terrain : choices.terrain;
    sceneView?.setTerrain(TERRAINS[terrain]!);
    showOverlays();
    parts.live.begin(choices);
  };
  /** Clears messages about the previous world; those about the link or the browser come before the first world. */
  const beginAnew = () => {
    notice.clear();
    beginWorld();
  };
  const change = (name: keyof Choices, text: string): string | null => {
    const reason = setChoice(choices, name, text);
    if (reason !== null) return reason;
    // A flight belongs to one world: another begins without it.
    if (name !== 'flight' && !LIVE_CHOICES.includes(name)) choices.flight = '';
    if (LIVE_CHOICES.includes(name) && !isSeen(name, room, choices)) applyLive(name);
    else beginAnew();
    address.write(query());
    parts.panel.show(choices);
    return null;
  };
  return {
    change,
    choose: (name, text) => void change(name, text),
    beginAnew,
    beginWorld,
    isGame: (scenario) => scenario === FREE_FLIGHT.name || findMission(scenario) !== null,
    openHelp: createHelpOpener(page, parts),
    follow(scenario, terrain) {
      if (setChoice(choices, 'scenario', scenario) !== null || !Object.hasOwn(TERRAINS, terrain)) return;
      sceneView?.setTerrain(TERRAINS[terrain]!);
      parts.panel.show(choices);
    },
    invite() {
      room ||= `tab:${Math.random().toString(36).slice(2, 8)}`;
      parts.game.markIntervention('another pilot joined');
      parts.live.operate({ kind: 'invite', address: room });
      address.copy(`?server=${room}`, 'Link copied: open it in another tab of this browser.');
    },
  };
}

/** Others see a new name from the next world on. */
function isSeen(name: keyof Choices, room: string, { server }: Choices): boolean {
  return name === 'pilot' && (room !== '' || TAB_ADDRESS.test(server));
}

/** The dialog is loaded when first opened. */
function createHelpOpener(page: Page, parts: Parts): () => void {
  let help: Promise<Help> | null = null;
  return () => {
    help ??= import('../panels/help').then(({ createHelp }) =>
      createHelp(
        page.document,
        () => page.keys,
        (next) => {
          page.keys = next;
          saveKeys(page.store, next);
          parts.game.reword();
        },
        keyCapOf(page, parts),
      ),
    );
    help.then(
      ({ open }) => open(),
      () => {
        help = null;
        page.notice.show('The list of keys did not load. Check the network and press the key again.');
      },
    );
  };
}
