import type { InputRecord } from '../../wire';

/** Controls from the start of a substep on. */
export type ScheduledInput = Omit<InputRecord, 'seq'>;
