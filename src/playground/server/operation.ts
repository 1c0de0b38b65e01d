import { ok, type Result, err } from '../../dynamics';
import { TAB_ADDRESS } from './tabAddress';
import { loadNetwork, type NetworkNumbers, type ScheduledInput } from '../../scenarios';

/** Commands of the page's operator to the server in the worker, besides the protocol. */
export type Operation =
  | LoadOperation
  /** From the next tick. */
  | { readonly kind: 'pause'; readonly paused: boolean }
  /** Only while paused. */
  | { readonly kind: 'step'; readonly unit: 'substep' | 'tick' }
  /** Hz, from the next tick. */
  | { readonly kind: 'tickRate'; readonly tickRate: number }
  | { readonly kind: 'timeScale'; readonly timeScale: number }
  /** `up`: of the messages to the server, where they differ. */
  | { readonly kind: 'network'; readonly numbers: NetworkNumbers; readonly up?: NetworkNumbers }
  /** Nothing arrives for some wall seconds, in either direction; then everything does. */
  | { readonly kind: 'spike'; readonly seconds: number }
  /** The player's ship as it was at the start. */
  | { readonly kind: 'restart' }
  /** Pushes the player's ship: [east, north, up] at the scenario's site, m/s and rad/s. */
  | { readonly kind: 'kick'; readonly velocity: Triple; readonly spin: Triple }
  /** Keeps the state of all ships, and puts them back into it, over the same ground. */
  | { readonly kind: 'snapshot' }
  | { readonly kind: 'restore' }
  /** Puts the player's ship at rest, `offset` (ICRF axes, m) from its position at the start of the drag. */
  | { readonly kind: 'drag'; readonly offset: Triple; readonly begins: boolean }
  | { readonly kind: 'freeze'; readonly frozen: boolean }
  | { readonly kind: 'drop' }
  /** Lets other tabs of this browser in, by an address of the form tab:…. */
  | { readonly kind: 'invite'; readonly address: string }
  /** Asks for the inputs that have acted on the player's ship since the load. */
  | { readonly kind: 'run' }
  | { readonly kind: 'reconnect' };

type Triple = readonly [number, number, number];

/** A new world: everything before it is gone, and `onOpen` comes before its first bytes. */
export interface LoadOperation {
  readonly kind: 'load';
  /** A name in SCENARIOS. */
  readonly scenario: string;
  /** In place of the scenario's; '' for the scenario's own. */
  readonly body: string;
  readonly shipClass: string;
  readonly terrain: string;
  /** The law's `surface_normal`; absent or '': the scenario's own. */
  readonly surfaceNormal?: '' | 'radial' | 'terrain';
  /** Hz */
  readonly tickRate: number;
  readonly timeScale: number;
  readonly network: NetworkNumbers;
  /** Of the messages to the server, where they differ. */
  readonly upNetwork?: NetworkNumbers;
  /** Scheduled inputs of the player's ship, in place of the scenario's. */
  readonly plan?: readonly ScheduledInput[];
  /** A whole number ≥ 0. */
  readonly seed: number;
  /** Like the game's own server: no hello, no fields 31–34, whole-tick inputs. */
  readonly legacy: boolean;
  /** Ships of other players, 0 … 1000. */
  readonly others: number;
  /** Name of the pilot of the player's ship; '' or absent: the page's. */
  readonly pilot?: string;
}

const MAX_OTHERS = 1000;
/** Wall s. */
const MAX_SPIKE = 30;

/** The operation, or an error that names the field. Names and rates are checked by the world. */
export function loadOperation(given: unknown): Result<Operation> {
  if (typeof given !== 'object' || given === null) return err('operation: expected an object');
  const operation = given as Operation;
  switch (operation.kind) {
    case 'load':
      return loadLoad(operation);
    case 'pause':
      return flag('paused', operation.paused, operation);
    case 'freeze':
      return flag('frozen', operation.frozen, operation);
    case 'step':
      return operation.unit === 'tick' || (operation.unit as unknown) === 'substep'
        ? ok(operation)
        : err("unit: expected 'tick' or 'substep'");
    case 'network':
      return loadNetworks(operation.numbers, operation.up, (numbers, up) => ({
        kind: 'network',
        numbers,
        ...(up !== undefined && { up }),
      }));
    case 'spike':
      return operation.seconds > 0 && operation.seconds <= MAX_SPIKE
        ? ok(operation)
        : err(`seconds: expected up to ${MAX_SPIKE}, got ${String(operation.seconds)}`);
    case 'drag':
      return isTriple(operation.offset)
        ? flag('begins', operation.begins, operation)
        : err('offset: expected 3 finite numbers');
    case 'kick':
      if (!isTriple(operation.velocity)) return err('velocity: expected 3 finite numbers');
      return isTriple(operation.spin) ? ok(operation) : err('spin: expected 3 finite numbers');
    case 'invite':
      return TAB_ADDRESS.test(operation.address) ? ok(operation) : err('address: expected tab: and a name');
    case 'tickRate':
    case 'timeScale':
    case 'restart':
    case 'snapshot':
    case 'restore':
    case 'run':
    case 'drop':
    case 'reconnect':
      return ok(operation);
    default:
      return err(`kind: no operation ${String((given as { kind: unknown }).kind)}`);
  }
}

function loadLoad(given: LoadOperation): Result<Operation> {
  if (!Number.isSafeInteger(given.seed) || given.seed < 0)
    return err(`seed: expected a whole number ≥ 0, got ${String(given.seed)}`);
  if (!Number.isSafeInteger(given.others) || given.others < 0 || given.others > MAX_OTHERS)
    return err(`others: expected 0 to ${MAX_OTHERS}, got ${String(given.others)}`);
  return loadNetworks(given.network, given.upNetwork, (network, upNetwork) => ({
    ...given,
    network,
    ...(upNetwork !== undefined && { upNetwork }),
  }));
}

function loadNetworks(
  down: NetworkNumbers,
  up: NetworkNumbers | undefined,
  make: (down: NetworkNumbers, up: NetworkNumbers | undefined) => Operation,
): Result<Operation> {
  const numbers = loadNetwork(down);
  if (!numbers.ok) return err(`network.${numbers.reason}`);
  if (up === undefined) return ok(make(numbers.value, undefined));
  const upward = loadNetwork(up);
  return upward.ok ? ok(make(numbers.value, upward.value)) : err(`up.${upward.reason}`);
}

function flag(name: string, value: unknown, operation: Operation): Result<Operation> {
  return typeof value === 'boolean' ? ok(operation) : err(`${name}: expected true or false`);
}

function isTriple(value: unknown): boolean {
  return Array.isArray(value) && value.length === 3 && value.every((item) => Number.isFinite(item));
}
