import type { Diagnosis } from './drawn/view';

/** Counters at zero, gauges at rest. */
export function createDiagnosis(): Diagnosis {
  return {
    framesAccepted: 0,
    framesDuplicate: 0,
    framesOutOfOrder: 0,
    framesTooOld: 0,
    framesFromFuture: 0,
    framesRefused: 0,
    shipsRefused: 0,
    lastRefusal: '',
    helloReceived: false,
    correctionsLateInput: 0,
    correctionsLostInput: 0,
    correctionsOtherPilot: 0,
    correctionsMismatch: 0,
    lastMismatch: '',
    replayedSubsteps: 0,
    steppedSubsteps: 0,
    budgetOverruns: 0,
    snaps: 0,
    resyncs: 0,
    rollbacksCompared: 0,
    rollbacksDifferent: 0,
    clockOffset: 0,
    clockRate: 1,
    roundTrip: 0,
    jitter: 0,
    lead: 0,
    margin: 0,
    errorPosition: Number.NaN,
    errorAngle: Number.NaN,
    offsetPosition: 0,
    offsetAngle: 0,
  };
}
