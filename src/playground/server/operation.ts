import { ok, type Result, err } from '../../dynamics';
import { TAB_ADDRESS } from './tabLink';
import { loadNetwork, type NetworkNumbers } from '../../scenarios';

/** What the page's operator asks of the server in the worker, beside the protocol. */
export type Operation =
  | LoadOperation
  /** Holds from the next tick. */
  | { readonly kind: 'pause'; readonly paused: boolean }
  /** Only while paused. */
  | { readonly kind: 'step'; readonly unit: 'substep' | 'tick' }
  /** Hz, from the next tick. */
  | { readonly kind: 'tickRate'; readonly tickRate: number }
  | { readonly kind: 'timeScale'; readonly timeScale: number }
  | { readonly kind: 'network'; readonly numbers: NetworkNumbers }
  /** The own ship as it was at the start. */
  | { readonly kind: 'restart' }
  /** Pushes the own ship: [east, north, up] at the scenario's site, m/s and rad/s. */
  | { readonly kind: 'kick'; readonly velocity: Triple; readonly spin: Triple }
  | { readonly kind: 'freeze'; readonly frozen: boolean }
  | { readonly kind: 'drop' }
  /** Lets other tabs of this browser in, by an address of the form tab:…. */
  | { readonly kind: 'invite'; readonly address: string }
  /** Asks for the inputs that have acted on the own ship since the load. */
  | { readonly kind: 'run' }
  | { readonly kind: 'reconnect' };

type Triple = readonly [number, number, number];

/** A new world: everything before it is gone, and `onOpen` comes before its first bytes. */
export interface LoadOperation {
  readonly kind: 'load';
  /** A name in SCENARIOS. */
  readonly scenario: string;
  /** Instead of the scenario's own, where not ''. */
  readonly body: string;
  readonly shipClass: string;
  readonly terrain: string;
  /** The law's `surface_normal`; absent or '': the scenario's own. */
  readonly surfaceNormal?: '' | 'radial' | 'terrain';
  /** Hz */
  readonly tickRate: number;
  readonly timeScale: number;
  readonly network: NetworkNumbers;
  /** A whole number ≥ 0. */
  readonly seed: number;
  /** As the game's own server speaks: no hello, no fields 31–34, whole-tick inputs. */
  readonly legacy: boolean;
  /** Ships of other players, 0 … 1000. */
  readonly others: number;
  /** Name of the own ship's pilot; '' or absent: the page's. */
  readonly pilot?: string;
}

const MAX_OTHERS = 1000;

/** The operation, or a reason that names the field. What the world itself checks (names, rates) is left to it. */
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
    case 'network': {
      const numbers = loadNetwork(operation.numbers);
      return numbers.ok ? ok({ kind: 'network', numbers: numbers.value }) : numbers;
    }
    case 'kick':
      if (!isTriple(operation.velocity)) return err('velocity: expected 3 finite numbers');
      return isTriple(operation.spin) ? ok(operation) : err('spin: expected 3 finite numbers');
    case 'invite':
      return TAB_ADDRESS.test(operation.address) ? ok(operation) : err('address: expected tab: and a name');
    case 'tickRate':
    case 'timeScale':
    case 'restart':
    case 'run':
    case 'drop':
    case 'reconnect':
      return ok(operation);
    default:
      return err(`kind: no operation ${String((given as { kind: unknown }).kind)}`);
  }
}

function loadLoad(given: LoadOperation): Result<Operation> {
  const network = loadNetwork(given.network);
  if (!network.ok) return err(`network.${network.reason}`);
  if (!Number.isSafeInteger(given.seed) || given.seed < 0)
    return err(`seed: expected a whole number ≥ 0, got ${String(given.seed)}`);
  if (!Number.isSafeInteger(given.others) || given.others < 0 || given.others > MAX_OTHERS)
    return err(`others: expected 0 to ${MAX_OTHERS}, got ${String(given.others)}`);
  return ok({ ...given, network: network.value });
}

function flag(name: string, value: unknown, operation: Operation): Result<Operation> {
  return typeof value === 'boolean' ? ok(operation) : err(`${name}: expected true or false`);
}

function isTriple(value: unknown): boolean {
  return Array.isArray(value) && value.length === 3 && value.every((item) => Number.isFinite(item));
}
