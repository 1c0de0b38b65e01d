import type { RunOutcome } from './flyRun';
import type { Mission } from './mission';

/** One line of a score: what was measured, the points it earned, and the rule for full points. */
export interface ScoreLine {
  readonly what: 'Hardest touch' | 'Distance' | 'Tilt' | 'Fuel' | 'Time' | 'Tipped over' | 'Goal missed';
  readonly measured: string;
  readonly points: number;
  readonly most: number;
  readonly rule: string;
}

export interface Score {
  /** 0 … 1000; 0 unless landed on every pad. */
  readonly total: number;
  readonly lines: readonly ScoreLine[];
}

/** Touch speeds that earn full points and none, m/s. */
const SOFT = 1;
const HARD = 10;
/** Degrees of tilt beyond the slope, after the touch, that earn full points and none. */
const STEADY = 3;
const LEANING = 30;
/** Multiple of the par that earns no points. */
const WASTED = 3;
const TIPPED_PENALTY = -150;
const GOAL_PENALTY = -400;

/** Scores a landing by touch speed, distance, tilt, fuel and time, each with its rule. */
export function scoreRun(mission: Mission, run: RunOutcome): Score {
  const { touchSpeed, distance, tilt, fuelUsed, seconds } = run;
  const slope = mission.slope ?? 0;
  const radius = Math.min(...mission.pads.map((pad) => pad.radius));
  const kg = (value: number) => `${value.toFixed(0)} kg`;
  const lines: ScoreLine[] = [
    line('Hardest touch', touchSpeed, `${touchSpeed.toFixed(1)} m/s`, {
      most: 300,
      full: SOFT,
      none: HARD,
      rule: `full points up to ${SOFT} m/s, none from ${HARD} m/s`,
    }),
    line('Distance', distance, `${distance.toFixed(1)} m`, {
      most: 250,
      full: 2,
      none: radius,
      rule: `full points within 2 m of the centre, none at the ring (${radius} m)`,
    }),
    line('Tilt', tilt, `${tilt.toFixed(1)}°`, {
      most: 100,
      full: slope + STEADY,
      none: slope + LEANING,
      rule: `full points up to ${slope + STEADY}°, none from ${slope + LEANING}°`,
    }),
    line('Fuel', fuelUsed, kg(fuelUsed), {
      most: 200,
      full: mission.parFuel,
      none: WASTED * mission.parFuel,
      rule: `full points up to ${kg(mission.parFuel)}, none from ${kg(WASTED * mission.parFuel)}`,
    }),
    line('Time', seconds, `${seconds.toFixed(1)} s`, {
      most: 150,
      full: mission.parSeconds,
      none: WASTED * mission.parSeconds,
      rule: `full points up to ${mission.parSeconds} s, none from ${WASTED * mission.parSeconds} s`,
    }),
  ];
  if (run.hasTipped)
    lines.push({
      what: 'Tipped over',
      measured: 'yes',
      points: TIPPED_PENALTY,
      most: 0,
      rule: 'the ship tipped over before it was righted',
    });
  if (run.outcome === 'landed' && !meetsGoal(mission, run))
    lines.push({
      what: 'Goal missed',
      measured: `${touchSpeed.toFixed(1)} m/s`,
      points: GOAL_PENALTY,
      most: 0,
      rule: `the goal was softer than ${mission.touchLimit!} m/s`,
    });
  const sum = lines.reduce((total, { points }) => total + points, 0);
  return { total: run.outcome === 'landed' ? Math.max(0, sum) : 0, lines };
}

/** Whether the run landed on every pad, as softly as the goal demands. */
export function meetsGoal({ touchLimit }: Mission, { outcome, touchSpeed }: RunOutcome): boolean {
  return outcome === 'landed' && touchSpeed <= (touchLimit ?? Infinity);
}

interface Rule {
  readonly most: number;
  readonly full: number;
  readonly none: number;
  readonly rule: string;
}

function line(what: ScoreLine['what'], value: number, measured: string, rule: Rule): ScoreLine {
  const share = Math.min(1, Math.max(0, (rule.none - value) / (rule.none - rule.full)));
  return { what, measured, points: Math.round(rule.most * share), most: rule.most, rule: rule.rule };
}
