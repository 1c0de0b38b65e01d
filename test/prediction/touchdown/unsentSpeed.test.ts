import { describe, expect, it } from 'vitest';
import { createPredictor } from '../../../src/prediction';
import type { ShipState } from '../../../src/wire';
import { named, OWN } from '../faults/feed';
import { frameAt, helloAt, STILL } from '../faults/restingShip';

const RATE = 20;
const [, UP] = STILL.relativePosition!;
const HIGH: ShipState = named('ship-1', {
  surfaceContactState: '',
  landedBodyName: '',
  position: [0, UP + 40, 0],
  relativePosition: [0, UP + 40, 0],
});

/** The card of a ship that is seen 40 m up, and on the ground one tick later: no prediction has the touch. */
function cardAfter(landed: Partial<ShipState>) {
  const predictor = createPredictor(OWN);
  predictor.receive(helloAt(1, RATE), 0);
  const ships = [HIGH, HIGH, HIGH, { ...STILL, ...landed }];
  ships.forEach((ship, n) => {
    predictor.receive(frameAt(n + 1, RATE, { ships: [ship] }), n / RATE);
    predictor.advance(null, n / RATE);
  });
  const { own } = predictor.view((ships.length - 1) / RATE);
  expect(own!.surfaceContactState).toBe('landed');
  return own!.touchdown;
}

describe('the card of a touch that only the server has seen', () => {
  it('has the speed that the server sends', () => {
    expect(cardAfter({ contactImpactSpeed: 1.4 })).toMatchObject({ known: true, verticalSpeed: 1.4 });
  });

  it.each([null, 0])(
    'is not shown with an impact speed of %s: a touch of 0.0 m/s does not exist',
    (speed) => {
      expect(cardAfter({ contactImpactSpeed: speed }).known).toBe(false);
    },
  );
});
