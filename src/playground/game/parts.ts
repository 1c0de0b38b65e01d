import type { ShipDrag } from '../input/shipDrag';
import type { Devices } from '../input/devices';
import type { Choices } from '../panels/choices';
import type { Panel } from '../panels/panel';
import type { LazyDock } from '../panels/workshop/lazyDock';
import type { Sound } from '../sound/sound';
import type { Cockpit } from '../view/cockpit';
import type { FrameLoop } from '../view/frameLoop';
import type { RecordingView } from '../recording/recordingView';
import type { Actions } from './actions/actions';
import type { FlightLink } from './flight/flightLink';
import type { Live } from './live/live';
import type { MissionGame } from './mission/missionGame';

/** All running parts, each created after those that it needs at creation. Parts that it calls later may be created after it. */
export interface Parts {
  live: Live;
  recording: RecordingView;
  dock: LazyDock;
  panel: Panel;
  chooser: Chooser;
  actions: Actions;
  game: MissionGame;
  cockpit: Cockpit;
  /** null without a picture. */
  shipDrag: ShipDrag | null;
  flightLink: FlightLink;
  devices: Devices;
  /** null until it is needed: its code is loaded then. */
  sound: Sound | null;
  loop: FrameLoop;
}

/** Applies choices. */
export interface Chooser {
  /** Why the text is invalid, or null. */
  readonly change: (name: keyof Choices, text: string) => string | null;
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly beginAnew: () => void;
  readonly beginWorld: () => void;
  readonly isGame: (scenario: string) => boolean;
  readonly openHelp: () => void;
  /** The host of a shared world has begun a scenario. */
  readonly follow: (scenario: string, terrain: string) => void;
  /** Lets other tabs in and copies the link. */
  readonly invite: () => void;
}
