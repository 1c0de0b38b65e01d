import type { Fields, JsonRecord } from '../fixtures/fields';

/** Named as in prediction; the predictor checks the contents of `changes` and `snapshot` when called. */
export type RecordedCall =
  | { readonly name: 'setOwnShip'; readonly shipId: string | null }
  | {
      readonly name: 'removeShip';
      readonly shipId: string;
      readonly reason: 'destroyed' | 'docked' | 'gone';
    }
  | { readonly name: 'teleported'; readonly shipId: string }
  | {
      readonly name: 'setPolicy';
      readonly shipId: string;
      readonly policy: 'predict' | 'interpolate' | 'hold';
    }
  | { readonly name: 'configure'; readonly changes: unknown }
  | { readonly name: 'restore'; readonly snapshot: unknown }
  | { readonly name: 'reset' };

const NAMES = [
  ...(['setOwnShip', 'removeShip', 'teleported', 'setPolicy'] as const),
  ...(['configure', 'restore', 'reset'] as const),
] as const;

/** Reads a call from its line; a fault names the invalid member. */
export function readCall(fields: Fields, given: JsonRecord): RecordedCall {
  const name = fields.choice(given['name'], 'call.name', NAMES);
  const shipId = () => fields.text(given['shipId'], 'call.shipId');
  switch (name) {
    case 'setOwnShip':
      return { name, shipId: given['shipId'] === null ? null : shipId() };
    case 'removeShip':
      return {
        name,
        shipId: shipId(),
        reason: fields.choice(given['reason'], 'call.reason', ['destroyed', 'docked', 'gone']),
      };
    case 'teleported':
      return { name, shipId: shipId() };
    case 'setPolicy':
      return {
        name,
        shipId: shipId(),
        policy: fields.choice(given['policy'], 'call.policy', ['predict', 'interpolate', 'hold']),
      };
    case 'configure':
      return { name, changes: given['changes'] };
    case 'restore':
      return { name, snapshot: given['snapshot'] };
    case 'reset':
      return { name };
  }
}
