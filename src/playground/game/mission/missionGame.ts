import type { WorldView } from '../../../prediction';
import type { LandingAids } from '../../../readout';
import { findMission, FREE_FLIGHT, type Mission, type RunInput } from '../../../scenarios';
import type { Action } from '../../input/keyTable';
import type { Choices } from '../../panels/choices';
import type { GoalPanel } from '../../panels/goal';
import type { CardAction, CardText, MissionCard } from '../../panels/missionCard';
import type { Notice } from '../../panels/notice';
import { type Address, copyFlight } from '../address';
import type { VerifiedRun } from './bestRuns';
import { adviceText, type Device, howToFly } from '../texts/flightTexts';
import { isRealServer } from '../../server/tabAddress';
import { createGhostFlight, type GhostFlight } from './ghost';
import type { Live } from '../live/live';
import type { Runs } from './runs';
import { confirmCap, crashCard, landedCard, nextAction, phaseCard } from './missionCards';
import { createMissionTracker, type MissionTracker } from './missionTracker';

/** Missions as a game: the goal, the result of a flight, the next step. */
export interface MissionGame {
  readonly tracker: MissionTracker;
  readonly ghost: GhostFlight;
  /** A new world has begun. */
  readonly begin: () => void;
  readonly watch: (view: WorldView) => void;
  /** Shows what to do now to land; null aids: they are off. */
  readonly advise: (view: WorldView, aids: LandingAids | null) => void;
  /** Enter, or the gamepad's A: the card's first action, or skip a lesson. */
  readonly confirm: () => void;
  /** The pilot changed the device, or the keys. */
  readonly reword: () => void;
  /** Marks that the flight no longer depends on the pilot alone, so that it is not scored. */
  readonly markIntervention: (how: string) => void;
  readonly onRun: (inputs: readonly RunInput[]) => void;
  /** A friend's run to race. */
  readonly race: (run: VerifiedRun) => void;
}

export interface MissionContext {
  readonly live: Live;
  readonly choices: () => Choices;
  readonly choose: (name: keyof Choices, text: string) => void;
  readonly restart: () => void;
  readonly goal: GoalPanel;
  readonly card: MissionCard;
  readonly address: Address;
  readonly notice: Notice;
  readonly runs: Runs;
  readonly device: () => Device;
  readonly cap: (action: Action) => string;
  readonly resetCamera: () => void;
  /** Shows a message for a few seconds. */
  readonly flash: (text: string) => void;
}

/** State of the present flight. */
interface Flight {
  /** Why it is not scored; '' if it is. */
  intervention: string;
  rival: VerifiedRun | null;
  actions: readonly CardAction[];
}

export function createMissionGame(context: MissionContext): MissionGame {
  const tracker = createMissionTracker();
  const ghost = createGhostFlight();
  const flight: Flight = { intervention: '', rival: null, actions: [] };
  const reword = () => showGoal(tracker.mission(), flight, context);
  const show = (card: CardText | null) => {
    const offered = card === null || context.choices().server === '' ? card : asGuest(card);
    flight.actions = offered?.actions ?? [];
    if (offered === null) context.card.hide();
    else context.card.show(offered);
    reword();
  };
  const showPhase = (mission: Mission) => {
    show(phaseCard(tracker, mission, context));
    if (tracker.phase() !== 'done' || mission.isLesson) return;
    if (flight.intervention === '') context.live.operate({ kind: 'run' });
    else show(landedCard(mission, `Not scored: ${flight.intervention}.`, context));
  };
  return {
    tracker,
    ghost,
    begin() {
      const { scenario, server } = context.choices();
      const mission = isRealServer(server) ? null : findMission(scenario);
      flight.intervention = unrankedReason(context.choices());
      tracker.begin(mission);
      show(null);
      void raceGhost(mission, flight.rival, { tracker, ghost, ...context });
      if (mission !== null) context.resetCamera();
    },
    watch(view) {
      const mission = tracker.mission();
      if (mission === null) {
        if (flight.actions.length === 0 && isWrecked(view, context)) show(crashCard(context, []));
      } else if (tracker.watch(view)) showPhase(mission);
    },
    advise: (view, aids) => context.goal.advise(adviceFor(tracker, view, aids, context)),
    confirm() {
      const mission = tracker.mission();
      if (mission !== null && isSkippable(mission, flight, context)) nextAction(mission, context).act();
      else flight.actions[0]?.act();
    },
    reword,
    markIntervention: (how) => (flight.intervention = how),
    onRun(inputs) {
      const mission = tracker.mission();
      if (mission !== null && tracker.phase() === 'done' && flight.intervention === '')
        void judge(mission, inputs, flight.rival, context).then((card) => {
          if (tracker.mission() === mission && tracker.phase() === 'done') show(card);
        });
    },
    race(run) {
      flight.rival = run;
      if (tracker.mission() === run.mission) ghost.race(run);
    },
  };
}

/** The goal and how to fly to it; free flight has none, a demonstration is not flown. */
function showGoal(mission: Mission | null, flight: Flight, context: MissionContext): void {
  const { goal, choices, device, cap } = context;
  const isTouch = device() === 'thumbs';
  const skips = isTouch && mission !== null && isSkippable(mission, flight, context);
  goal.offerSkip(skips ? nextAction(mission, context).act : null);
  if (mission !== null) goal.show(titleOf(mission, flight, context), mission.goal);
  else if (choices().scenario === FREE_FLIGHT.name || isRealServer(choices().server))
    goal.show(FREE_FLIGHT.title, FREE_FLIGHT.about);
  else goal.hide();
  goal.how(howToFly(mission, device(), cap));
}

/** The key that skips a lesson stands beside its title; a touch screen has a button there. */
function titleOf(mission: Mission, flight: Flight, context: MissionContext): string {
  const cap = isSkippable(mission, flight, context) ? confirmCap(context) : '';
  const { title } = mission.scenario;
  return cap === '' ? title : `${title} · ${cap} to skip`;
}

/** A lesson can be skipped, but not by a guest, nor while the card offers the same or takes the same key for something else. */
function isSkippable(mission: Mission, { actions }: Flight, context: MissionContext): boolean {
  if (!mission.isLesson || context.choices().server !== '') return false;
  const next = nextAction(mission, context);
  return !actions.some(({ text, cap }) => text === next.text || (cap !== '' && cap === next.cap));
}

/** A guest cannot begin another world. */
function asGuest({ actions, words, ...card }: CardText): CardText {
  const hint = actions.length > 0 ? 'Only the host can restart or continue.' : '';
  return { ...card, words: `${words} ${hint}`.trim(), actions: [] };
}

/** Without a mission a crash also ends the flight; a real server spawns a new ship by itself. */
function isWrecked({ own }: WorldView, { choices }: MissionContext): boolean {
  return own?.shownState === 'crashed' && choices().server === '';
}

/** No advice to descend beside the pad, except that the tank is empty; none at all after the landing or for the autopilot. */
function adviceFor(
  tracker: MissionTracker,
  view: WorldView,
  aids: LandingAids | null,
  { device, cap, live }: MissionContext,
): string {
  const isEmpty = view.own !== null && view.own.fuel <= 0;
  const done = tracker.mission()?.done;
  if (tracker.phase() === 'done') return '';
  if (done?.kind === 'hover')
    return tracker.held() > 0 ? `${Math.ceil(done.seconds - tracker.held())} s to go` : '';
  if (aids === null || done?.kind !== 'land' || live.flightControls.autopilot.isOn()) return '';
  return tracker.isOverPad() || aids.advice === 'more' || isEmpty
    ? adviceText(aids, view, device(), cap)
    : '';
}

/** Shows the rival's run in its mission, the pilot's own best run in the others. */
async function raceGhost(
  mission: Mission | null,
  rival: VerifiedRun | null,
  { tracker, ghost, runs, flash }: Pick<MissionGame, 'tracker' | 'ghost'> & MissionContext,
): Promise<void> {
  const isRace = rival !== null && rival.mission === mission;
  ghost.race(isRace ? rival : null);
  if (mission === null || isRace || !runs.isKept(mission)) return;
  const loaded = await runs.load().catch(() => null);
  const best = loaded?.best.of(mission) ?? null;
  if (best === null || tracker.mission() !== mission) return;
  ghost.race(best);
  flash(`The ghost beside you is your best flight: ${best.score.total} of 1000.`);
}

/** Replays the run, stores it if it is the best, and shows its score. */
async function judge(
  mission: Mission,
  inputs: readonly RunInput[],
  rival: VerifiedRun | null,
  context: MissionContext,
): Promise<CardText> {
  try {
    const { module, best } = await context.runs.load();
    const run = module.verifyRun(mission, inputs);
    if (run?.outcome.outcome !== 'landed')
      return landedCard(mission, 'Not scored: the replay of its inputs does not land.', context);
    const before = best.of(mission);
    const isBest = best.keep(run);
    const copyRace = () =>
      copyFlight(context, module.raceQuery(run, context.choices().pilot), 'Race link copied.');
    return module.scoreCard(run, module.verdict(run, before, rival, isBest), copyRace, context);
  } catch {
    return landedCard(mission, 'Not scored: part of the page did not load.', context);
  }
}

/** Why a changed world is not scored; '' if it is the mission's. */
function unrankedReason({
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
  if (server !== '') return 'it was flown as a guest';
  if (body !== '' || shipClass !== '' || (terrain !== '' && terrain !== 'hills'))
    return 'the world was changed';
  if (tickRate !== 0 || timeScale !== 0 || legacy !== 0) return 'the server was changed';
  return slow < 1 ? 'it was flown in slow motion' : '';
}
