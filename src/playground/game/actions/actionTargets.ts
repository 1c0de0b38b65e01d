import type { Banner } from '../../panels/banner';
import type { Choices } from '../../panels/choices';
import type { Panel } from '../../panels/panel';
import type { ReplayDeck } from '../../recording/replayDeck';
import type { Live } from '../live/live';

/** The objects that keys, gamepads and buttons act on. */
export interface ActionTargets {
  readonly live: Live;
  readonly panel: Panel;
  readonly banner: Banner;
  readonly choices: () => Choices;
  /** Applies a choice. */
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly begin: () => void;
  readonly help: () => void;
  readonly resetCamera: () => void;
  readonly nextCamera: () => void;
  readonly copyLink: () => void;
  readonly copyFlight: () => void;
  /** Lets another tab in, and copies its link. */
  readonly invite: () => void;
  readonly toggleBare: () => void;
  readonly toggleAids: () => void;
  readonly toggleSound: () => void;
  /** Switches dragging the ship on or off. Returns whether it is on. */
  readonly toggleDrag: () => boolean;
  /** While a recording plays, the game behind it takes no commands. */
  readonly deck: ReplayDeck;
  /** Marks that the flight no longer depends on the pilot's inputs alone. */
  readonly markIntervention: (how: string) => void;
}
