import { it } from 'vitest';
import { expectUnittest, isMissing } from './pythonTests';

it.skipIf(isMissing('redis'))(
  'killed in mid-bounce twenty times, alone and with Redis, it continues bit for bit and reports each event once',
  () => expectUnittest('test_crash'),
  10 * 60_000,
);
