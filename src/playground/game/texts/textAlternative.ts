import type { WorldView } from '../../../prediction';
import type { LandingReadout } from '../../../readout';
import { placeName } from './placeName';

/** A text description of the picture for screen readers. Updated every two seconds, never announced. */
export interface TextAlternative {
  readonly update: (view: WorldView, readout: LandingReadout, now: number) => void;
}

const EVERY = 2;

const STATES: Readonly<Record<string, string>> = {
  '': 'is in flight',
  contact: 'is in contact with the ground',
  landed: 'has landed',
  tipped: 'lies on its side',
  crashed: 'has crashed',
};

export function createTextAlternative(element: Element): TextAlternative {
  let toldAt = -Infinity;
  return {
    update(view, readout, now) {
      if (now - toldAt < EVERY && now >= toldAt) return;
      toldAt = now;
      element.textContent = words(view, readout);
    },
  };
}

function words(view: WorldView, readout: LandingReadout): string {
  const ship = view.own ?? view.ships[0];
  const body = ship === undefined ? undefined : view.bodies[ship.body];
  if (!view.ready || ship === undefined || body === undefined) return 'No ship in view yet.';
  const height = Math.max(0, ship.feetHeight);
  const parts = [
    `${ship.name}, a ${ship.shipClass.name.replaceAll('_', ' ')}, ${STATES[ship.shownState] ?? ''}`,
  ];
  if (ship.shownState === '')
    parts.push(`${height < 10 ? height.toFixed(1) : height.toFixed(0)} m above ${placeName(body.name)}`);
  else parts.push(`on ${placeName(body.name)}`);
  const engine = ship.controls.thrustLevel;
  if (engine > 0) parts.push(`engine at ${Math.round(engine * 100)} %`);
  const others = view.ships.length - 1;
  if (others > 0) parts.push(`${others} other ${others === 1 ? 'ship' : 'ships'}`);
  if (readout.withdrawn !== '') parts.push(`${readout.withdrawn} withdrawn`);
  return `${parts.join(', ')}.`;
}
