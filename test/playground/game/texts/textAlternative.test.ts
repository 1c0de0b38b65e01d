import { expect, it } from 'vitest';
import { createTextAlternative } from '../../../../src/playground/game/texts/textAlternative';
import { createLandingReadout } from '../../../../src/readout';
import { makeShip, makeView } from '../../../readout/views';

/** The text beside the picture, for the player's ship and `others` more. */
function textWith(others: number): string {
  const element = { textContent: '' };
  const view = makeView({ clearance: 86 });
  const more = Array.from({ length: others }, (_, n) => ({
    ...makeShip({}),
    shipId: `other-${n}`,
    own: false,
  }));
  const ships = [...view.ships, ...more];
  createTextAlternative(element as Element).update({ ...view, ships }, createLandingReadout(), 0);
  return element.textContent;
}

it('the text of the picture counts the other ships: none, one other ship, two other ships', () => {
  expect(textWith(0)).not.toContain('other');
  expect(textWith(1)).toMatch(/, 1 other ship\.$/);
  expect(textWith(2)).toMatch(/, 2 other ships\.$/);
  expect(textWith(0)).toMatch(/in flight, 86 m above the Moon/);
});
