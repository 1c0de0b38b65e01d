import { describe } from '../checks/describe';
import { changePolicy } from '../lifecycle/policy';
import { changeOwnShip, dropShip, expectTeleport } from '../ownership';
import { announce, type Session } from '../session';
import type { Predictor } from './api';
import type { Life } from './life';

/** The calls about single ships. A call without a ship id is ignored, with a warning. */
export function shipCalls(session: Session, life: Life) {
  const isOf = (call: string, shipId: unknown): boolean =>
    life.carriesOut(call) && isShipId(session, call, shipId);
  return {
    setOwnShip(shipId) {
      if (shipId === null ? life.carriesOut('setOwnShip') : isOf('setOwnShip', shipId))
        changeOwnShip(session, shipId ?? '');
    },
    removeShip(shipId, reason) {
      if (!isOf('removeShip', shipId)) return;
      dropShip(session, shipId, reason);
      announce(session);
    },
    teleported(shipId) {
      if (isOf('teleported', shipId)) expectTeleport(session, shipId);
    },
    setPolicy(shipId, policy) {
      if (isOf('setPolicy', shipId)) changePolicy(session, shipId, policy);
    },
  } satisfies Partial<Predictor>;
}

function isShipId({ warn }: Session, call: string, shipId: unknown): boolean {
  if (typeof shipId === 'string') return true;
  const message = `${call}: expected a ship id (a string), got ${describe(shipId)}. The call was ignored.`;
  warn('ship-id', message, { field: call, value: shipId });
  return false;
}
