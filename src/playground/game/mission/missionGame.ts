import type { WorldView } from '../../../prediction';
import { findMission, LESSONS, meetsGoal, type Mission, MISSIONS, type RunInput } from '../../../scenarios';
import type { Action } from '../../input/keyTable';
import type { Choices } from '../../panels/choices';
import type { GoalPanel } from '../../panels/goal';
import type { CardAction, MissionCard } from '../../panels/missionCard';
import type { Notice } from '../../panels/notice';
import type { Address } from '../address';
import { type BestRuns, raceQuery, type VerifiedRun, verifyRun } from './bestRuns';
import { controlName, type Device, howToFly } from '../words/flightWords';
import { createGhostFlight, type GhostFlight } from './ghost';
import type { Live } from '../live';
import { LONGEST_LINK } from './runText';
import { createMissionTracker, type MissionTracker } from './missionTracker';

/** Missions as a game: the goal, what a flight came to, what to do next. */
export interface MissionGame {
  readonly tracker: MissionTracker;
  readonly ghost: GhostFlight;
  /** A new world has begun. */
  readonly begin: () => void;
  readonly watch: (view: WorldView) => void;
  /** Enter, or the gamepad's A: the card's first action, or skip a lesson. */
  readonly confirm: () => void;
  /** The pilot changed the device, or the keys. */
  readonly reword: () => void;
  /** The flight is not the pilot's alone any more: it is not scored. */
  readonly meddled: (how: string) => void;
  readonly onRun: (inputs: readonly RunInput[]) => void;
  /** A friend's run to race. */
  readonly race: (run: VerifiedRun) => void;
}

export interface MissionPlace {
  readonly live: Live;
  readonly choices: () => Choices;
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly restart: () => void;
  readonly goal: GoalPanel;
  readonly card: MissionCard;
  readonly address: Address;
  readonly notice: Notice;
  readonly best: BestRuns;
  readonly device: () => Device;
  readonly cap: (action: Action) => string;
  readonly resetCamera: () => void;
}

export function createMissionGame(place: MissionPlace): MissionGame {
  const tracker = createMissionTracker();
  const ghost = createGhostFlight();
  let meddling = '';
  let rival: VerifiedRun | null = null;
  let actions: readonly CardAction[] = [];

  const reword = () => place.goal.how(howToFly(tracker.mission(), place.device(), place.cap));
  const show = (
    title: string,
    words: string,
    next: readonly CardAction[],
    run: VerifiedRun | null = null,
  ) => {
    actions = next;
    place.card.show({ title, words, lines: run?.score.lines ?? [], actions: next });
  };
  const enter = () => ({ keys: 'Enter', gamepad: 'A', thumbs: '' })[place.device()];
  const onward = (mission: Mission): CardAction => {
    const list = mission.isLesson ? LESSONS : MISSIONS;
    const next = list[list.indexOf(mission) + 1] ?? MISSIONS[0]!;
    return {
      text: `Next: ${next.scenario.title}`,
      cap: enter(),
      act: () => place.choose('scenario', next.scenario.name),
    };
  };
  const again = (): CardAction => ({
    text: 'Try again',
    cap: controlName(place.device(), 'restart', place.cap),
    act: place.restart,
  });

  const tell = (mission: Mission) => {
    const phase = tracker.phase();
    if (phase === 'crashed')
      show('Crashed', 'Too fast: a touch above 50 m/s breaks the ship.', [
        { ...again(), cap: enter() },
        onwardUnkeyed(onward(mission)),
      ]);
    else if (phase === 'tipped')
      show('Tipped over', 'Right the ship with the key the display names, or try again.', [again()]);
    else if (phase === 'beside')
      show(
        mission.done.kind === 'land' ? `Landed ${tracker.off().toFixed(0)} m from the beacon` : 'Landed',
        mission.done.kind === 'land'
          ? 'Take off again and land inside the ring, or try again.'
          : mission.goal,
        [again()],
      );
    else if (phase === 'padReached')
      show(`Pad ${tracker.reached()} of ${mission.pads.length}`, 'On to the next beacon.', []);
    else if (phase === 'done') tellDone(mission);
    else {
      actions = [];
      place.card.hide();
    }
  };
  const tellDone = (mission: Mission) => {
    if (mission.isLesson) {
      show('Well done', mission.scenario.about, [onward(mission), again()]);
      return;
    }
    show('Landed', 'The flight is being checked …', [onward(mission), again()]);
    if (meddling === '') place.live.operate({ kind: 'run' });
    else show('Landed', `Not scored: ${meddling}.`, [onward(mission), again()]);
  };

  return {
    tracker,
    ghost,
    begin() {
      const { scenario } = place.choices();
      const mission = findMission(scenario);
      meddling = whyUnranked(place.choices());
      actions = [];
      tracker.begin(mission);
      place.card.hide();
      ghost.race(mission === null ? null : rival?.mission === mission ? rival : place.best.of(mission));
      if (mission !== null) place.resetCamera();
      if (mission === null) place.goal.hide();
      else place.goal.show(mission.scenario.title, mission.goal);
      reword();
    },
    watch(view) {
      const mission = tracker.mission();
      if (mission !== null && tracker.watch(view)) tell(mission);
    },
    confirm() {
      const mission = tracker.mission();
      if (actions.length > 0) actions[0]!.act();
      else if (mission?.isLesson === true) onward(mission).act();
    },
    reword,
    meddled: (how) => (meddling = how),
    onRun(inputs) {
      const mission = tracker.mission();
      if (mission === null || tracker.phase() !== 'done' || meddling !== '') return;
      const run = verifyRun(mission, inputs);
      if (run?.outcome.outcome !== 'landed') {
        show('Landed', 'Not scored: flown again from its inputs, it does not land.', [
          onward(mission),
          again(),
        ]);
        return;
      }
      const best = place.best.of(mission);
      const isBest = place.best.keep(run);
      show(
        `${meetsGoal(mission, run.outcome) ? 'Landed' : 'Landed too hard'}: ${run.score.total} of 1000`,
        verdict(run, best, rival, isBest),
        [onward(mission), again(), { text: 'Copy race link', cap: '', act: () => share(place, run) }],
        run,
      );
    },
    race(run) {
      rival = run;
    },
  };
}

function onwardUnkeyed(action: CardAction): CardAction {
  return { ...action, cap: '' };
}

/** Flown from its inputs alone: a friend who opens the link sees this very flight, and the score is computed there again. */
function share({ address, notice }: MissionPlace, run: VerifiedRun): void {
  const query = raceQuery(run, '');
  if (query.length > LONGEST_LINK)
    notice.tell(`This flight makes a link of ${query.length} characters; some programs cut links that long.`);
  address.copy(query, 'Race link copied.');
}

function verdict(
  run: VerifiedRun,
  best: VerifiedRun | null,
  rival: VerifiedRun | null,
  isBest: boolean,
): string {
  const parts: string[] = [];
  if (rival?.mission === run.mission) {
    const ahead = run.score.total - rival.score.total;
    parts.push(ahead > 0 ? `${ahead} points ahead of ${rival.by}.` : `${-ahead} points behind ${rival.by}.`);
  }
  if (isBest) parts.push(best === null ? 'Your first score here.' : `Your best: ${best.score.total} before.`);
  else if (best !== null) parts.push(`Your best is ${best.score.total}.`);
  return parts.join(' ');
}

/** A world that is not the mission's is not scored; '' where it is. */
function whyUnranked({
  body,
  shipClass,
  terrain,
  tickRate,
  timeScale,
  slow,
  server,
  legacy,
  flight,
}: Choices): string {
  if (flight !== '') return 'it was flown from a link';
  if (server !== '') return 'a real server keeps no inputs';
  if (body !== '' || shipClass !== '' || (terrain !== '' && terrain !== 'hills'))
    return 'the world was changed';
  if (tickRate !== 0 || timeScale !== 0 || legacy !== 0) return 'the server was changed';
  return slow < 1 ? 'it was flown in slow motion' : '';
}
