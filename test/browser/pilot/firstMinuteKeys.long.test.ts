/** The first minute by keyboard, at the sizes of laptop and wide screen. */
import { testNewcomer } from './firstMinute';
import { describeInBrowser } from '../pages';
import { WINDOW_SIZES } from '../windowSizes';

describeInBrowser('the built page', () => {
  testNewcomer(WINDOW_SIZES.filter(({ isTouch }) => !isTouch));
});
