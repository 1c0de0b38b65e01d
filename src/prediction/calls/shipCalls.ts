import { describe } from '../checks/describe';
import { changeOwnShip, dropShip, expectTeleport, type Removal } from '../ownership';
import type { Session } from '../session';
import type { Predictor } from './api';
import type { Lifetime } from './lifetime';

const REMOVALS: readonly unknown[] = ['destroyed', 'docked', 'gone'] satisfies readonly Removal[];

/** The calls about single ships. A call without a ship id is ignored, with a warning. */
export function shipCalls(session: Session, lifetime: Lifetime) {
  const isOf = (call: string, shipId: unknown): boolean =>
    lifetime.carriesOut(call) && isShipId(session, call, shipId);
  return {
    setOwnShip(shipId) {
      if (shipId === null ? lifetime.carriesOut('setOwnShip') : isOf('setOwnShip', shipId))
        changeOwnShip(session, shipId ?? '');
    },
    removeShip(shipId, reason) {
      if (!isOf('removeShip', shipId)) return;
      if (!REMOVALS.includes(reason))
        session.warn(
          'removal-unknown',
          `removeShip(id, reason): expected ${REMOVALS.join(', ')}, got ${describe(reason)}. It counts as gone.`,
          { shipId, reason },
        );
      dropShip(session, shipId, reason);
      session.features.announce?.(session);
    },
    teleported(shipId) {
      if (isOf('teleported', shipId)) expectTeleport(session, shipId);
    },
  } satisfies Partial<Predictor>;
}

/** Whether a JavaScript caller's `shipId` is one; warns if not. */
export function isShipId({ warn }: Session, call: string, shipId: unknown): boolean {
  if (typeof shipId === 'string') return true;
  warn('ship-id', `${call}: expected a ship id (a string), got ${describe(shipId)}. The call was ignored.`, {
    field: call,
    value: shipId,
  });
  return false;
}
