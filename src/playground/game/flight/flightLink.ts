import type { Recording, RunInput } from '../../../scenarios';
import { type Choices, readChoices, writeChoices } from '../../panels/choices';
import type { Notice } from '../../panels/notice';
import { type Address, copyFlight } from '../address';
import type { Live } from '../live/live';
import { readFlight, writeFlight } from '../mission/runText';
import { scriptOf } from '../live/script';

export interface FlightLinkContext {
  readonly live: () => Live;
  readonly choices: () => Choices;
  readonly address: Address;
  readonly notice: Notice;
}

/** Links to flights: a link replays the same inputs in the same world, to the same bits. */
export interface FlightLink {
  /** Copies the flight so far, once the server has sent its inputs. */
  readonly copy: () => void;
  /** Takes the server's inputs; returns whether `copy` requested them. */
  readonly take: (inputs: readonly RunInput[]) => boolean;
  /** Copies the flight of a recording, in the world named in its note. */
  readonly copyOf: (recording: Recording) => void;
}

export function createFlightLink({ live, choices, address, notice }: FlightLinkContext): FlightLink {
  let isAsked = false;
  const put = (world: Choices, inputs: readonly RunInput[]) => {
    const { substeps } = scriptOf(world);
    const flown = continued(world.flight, inputs, substeps);
    const query = writeChoices({ ...world, flight: writeFlight(flown, substeps) });
    copyFlight(
      { address, notice },
      query,
      flown.length === 0 ? 'Link copied: nothing was flown by hand.' : 'Flight link copied.',
    );
  };
  return {
    copy() {
      isAsked = true;
      live().operate({ kind: 'run' });
    },
    take(inputs) {
      const wasAsked = isAsked;
      isAsked = false;
      if (wasAsked) put(choices(), inputs);
      return wasAsked;
    },
    copyOf({ header, entries }) {
      const { choices: world } = readChoices(new URLSearchParams(header.note));
      const inputs = entries.flatMap((entry) =>
        entry.kind === 'sent' && entry.message.kind === 'inputs' ? entry.message.inputs : [],
      );
      const newest = new Map(
        inputs.map(({ seq, tick, substep, controls }) => [seq, { tick, substep, controls }]),
      );
      put(world, [...newest.values()]);
    },
  };
}

/** The flight that a link brought, until the pilot took over. */
function continued(flight: string, inputs: readonly RunInput[], substeps: number): readonly RunInput[] {
  const brought = flight === '' ? null : readFlight(flight, substeps);
  if (brought?.ok !== true) return inputs;
  const at = ({ tick, substep }: RunInput) => tick * substeps + substep;
  const first = inputs[0] === undefined ? Infinity : at(inputs[0]);
  return [...brought.value.filter((input) => at(input) < first), ...inputs];
}
