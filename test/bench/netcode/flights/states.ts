import { NEUTRAL_CONTROLS } from '../../../../src/dynamics';
import type { EventNotice } from '../../../../src/prediction';
import { type Figure, spread } from '../figure';
import { type Flight, flyMeasured } from './flights';
import { flyPilot } from './law';

const SCENARIOS = ['opening', 'settle', 'bounce', 'slide', 'topple', 'right-itself', 'launch', 'crash'];

/** Predicted events compared with the server's, and the number of corrections. */
export function* stateFigures(): Generator<Figure> {
  const known = SCENARIOS.map((scenario) => flyMeasured({ scenario }, 28));
  const off = known.flatMap(timeErrors);
  yield {
    name: 'event time, inputs known',
    unit: 'substeps',
    ...spread(off),
    target: '0: the server’s substep',
    met: off.length > 0 && off.every((error) => error === 0),
    note: `${off.length} events of ${SCENARIOS.length} scenarios, all confirmed`,
  };
  const late = Array.from({ length: 6 }, (_, i) => flyPilot(i + 1, 0.1));
  const open = late.flatMap(openPredictions);
  const retracted = late.flatMap(({ rig }) => rig.notices.filter(({ kind }) => kind === 'retracted'));
  yield {
    name: 'predictions neither confirmed nor retracted by the first frame that covers them, 10 % of inputs late',
    unit: '',
    value: open.length,
    target: '0',
    met: open.length === 0,
    note: `${retracted.length} retracted`,
  };
  const seconds = late.length * 62;
  const sum = (pick: (flight: Flight) => number) => late.reduce((total, flight) => total + pick(flight), 0);
  yield {
    name: 'cost: corrections a second, 10 % of inputs late',
    unit: '1/s',
    value: sum(({ rig }) => rig.view().diagnosis.correctionsLateInput) / seconds,
    target: 'none set',
    met: true,
  };
  yield {
    name: 'cost: replayed substeps a second, 10 % of inputs late',
    unit: '1/s',
    value: sum(({ rig }) => rig.view().diagnosis.replayedSubsteps) / seconds,
    target: 'none set',
    met: true,
  };
  yield stickToScreen();
}

/** Substeps between a predicted event and the server's. */
function timeErrors({ rig }: Flight): number[] {
  const { substeps } = rig.authority.tempo.timing();
  const at = (event: { tick: number; substep: number | null }) => event.tick * substeps + event.substep!;
  return rig.truth.events.map((event) => {
    const predicted = rig.notices.filter(({ kind, type }) => kind === 'predicted' && type === event.type);
    return Math.min(...predicted.map((notice) => Math.abs(at(notice) - at(event))));
  });
}

/** Predicted events that a frame has covered with 50 substeps to spare, but that were neither confirmed nor retracted. */
function openPredictions({ rig }: Flight): EventNotice[] {
  const { substeps } = rig.authority.tempo.timing();
  const newest = (rig.authority.tickNumber() - 1) * substeps;
  const answered = rig.notices.filter(({ kind }) => kind !== 'predicted').length;
  const covered = rig.notices.filter(
    ({ kind, tick, substep }) => kind === 'predicted' && tick * substeps + substep + 50 <= newest,
  );
  return covered.slice(Math.min(covered.length, answered));
}

/** Wall time from the frame of a stick's movement to the first frame whose drawn pose differs from a run with an idle stick. */
function stickToScreen(): Figure {
  const delays: number[] = [];
  for (let i = 0; i < 20; i++) {
    const moved = 6 + i * 0.0137;
    let seen = Number.NaN;
    const poses: number[][] = [];
    const flight = { scenario: 'bounce', seed: i + 1 };
    flyMeasured({ ...flight, pilot: () => NEUTRAL_CONTROLS }, moved + 0.5, (_, view) => {
      if (view.own !== null) poses.push([...view.own.easedPosition]);
    });
    let frame = 0;
    flyMeasured(
      {
        ...flight,
        pilot: () => ({ ...NEUTRAL_CONTROLS, thrustLevel: frame / 60 >= moved ? 0.5 : 0 }),
      },
      moved + 0.5,
      (rig, view) => {
        frame += 1;
        if (view.own === null || !Number.isNaN(seen)) return;
        const idle = poses.shift()!;
        if (idle.some((value, k) => value !== view.own!.easedPosition[k])) seen = rig.now;
      },
    );
    delays.push((seen - Math.ceil(moved * 60) / 60) * 1000);
  }
  const { p50, max } = spread(delays);
  const met = max <= 1000 / 60 + 1e-6;
  return { name: 'delay: stick to screen', unit: 'ms', p50, max, target: '≤ one 60 Hz frame', met };
}
