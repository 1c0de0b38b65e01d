import { it } from 'vitest';
import { expectUnittest, isMissing } from './pythonTests';

it.skipIf(isMissing('redis'))(
  'killed in mid-bounce twenty times, alone and with Redis, it goes on bit for bit and tells each event once',
  () => expectUnittest('test_crash'),
  10 * 60_000,
);
