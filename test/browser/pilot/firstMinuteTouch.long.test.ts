/** The first minute by touch, at the sizes of phones. */
import { testNewcomer } from './firstMinute';
import { describeInBrowser } from '../pages';
import { WINDOW_SIZES } from '../windowSizes';

describeInBrowser('the built page', () => {
  testNewcomer(WINDOW_SIZES.filter(({ isTouch }) => isTouch));
});
