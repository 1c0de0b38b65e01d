import { registerServiceWorker } from '../offline/registerServiceWorker';
import { createFrameLoop, type FrameLoop } from '../view/frameLoop';
import { NIGHT_ELEVATION, type SceneView } from '../../scene';
import { pixelRatioOf } from '../view/pageSize';
import type { Notice } from '../panels/notice';
import { createTurns } from '../view/cockpit';
import type { Page } from './pageParts';
import { createReport } from './mission/report';
import { createTextAlternative } from './texts/textAlternative';
import type { Parts } from './parts';

/** One frame: reads the controls, takes the view, paints everything. */
export function wireFrames(page: Page, parts: Parts): FrameLoop {
  const { sceneView, canvas, window, choices, banner, resolution } = page;
  const root = page.document.documentElement;
  const textAlternative = createTextAlternative(page.part('textAlternative'));
  const report = createReport(root, parts);
  const autopilotEnd = createAutopilotEnd(page.notice);
  const nextTurn = createTurns();
  let before = NaN;
  let generation = 0;
  const loop = createFrameLoop(window, root, {
    sceneView,
    resolution,
    nextView(milliseconds) {
      parts.devices.read();
      parts.actions.tick(milliseconds / 1000);
      const now = parts.live.clock.now();
      const passed = Number.isNaN(before) ? 0 : now - before;
      before = now;
      const replayed = parts.recording.frame(passed);
      const replay = parts.recording.deck.replay();
      if (replay !== null && replay.generation() !== generation) {
        generation = replay.generation();
        parts.cockpit.forget();
      }
      return { view: replayed ?? parts.live.frame(), now };
    },
    paint(view, now, isFast) {
      const replay = parts.recording.deck.replay();
      if (replay === null) parts.game.watch(view);
      autopilotEnd(parts.live.flightControls.autopilot.reason());
      const hasDrawnDock = parts.dock.follow(view, now);
      parts.cockpit.paint(view, nextTurn(isFast, hasDrawnDock));
      const { flight, aids } = parts.cockpit;
      parts.game.advise(view, parts.cockpit.aidsOn() && replay === null ? aids : null);
      paintThumbs(parts);
      parts.sound?.follow(view.own, flight, aids);
      textAlternative.update(view, parts.cockpit.landing(), now);
      (replay?.baseline ?? parts.live.baseline).redraw(view, choices.mode, replay?.position() ?? now);
      if (sceneView !== null) updateScene(sceneView, parts);
      if (parts.loop.isWarm()) report(view);
    },
    isLoading: parts.live.isLoading,
    viewForScene: (view) => (parts.recording.deck.replay() === null ? parts.game.ghost.join(view) : view),
    opened() {
      banner.rest('');
      registerServiceWorker(window, () => (root.dataset['offline'] = 'ready'));
      // Creating the scene took seconds of the flight, so the world begins again.
      if (sceneView !== null && choices.server === '') parts.chooser.beginWorld();
    },
    fit() {
      const { clientWidth, clientHeight } = canvas;
      if (clientWidth > 0 && clientHeight > 0)
        sceneView?.resize(
          clientWidth,
          clientHeight,
          pixelRatioOf(window, clientWidth, resolution?.share() ?? 1),
        );
    },
  });
  return loop;
}

/** Night and marks: what the mission and the landing aids add to the picture. */
function updateScene(sceneView: SceneView, { game, cockpit }: Parts): void {
  const isNight = game.tracker.mission()?.night ?? false;
  sceneView.setSunElevation(isNight ? NIGHT_ELEVATION : null);
  sceneView.markers.pads = game.tracker.pads();
  const marksTouch = cockpit.aidsOn() && cockpit.aids.outcome === 'touch';
  sceneView.markers.touch = marksTouch ? cockpit.aids.touchPlace : null;
}

/** Shows why the autopilot disengaged, until it is switched on again. */
function createAutopilotEnd(notice: Notice): (reason: string) => void {
  let shown = '';
  const textOf = (reason: string) => `Autopilot off: ${reason}.`;
  return (reason) => {
    if (reason === shown) return;
    if (shown !== '') notice.withdraw(textOf(shown));
    if (reason !== '') notice.show(textOf(reason));
    shown = reason;
  };
}

/** What the lever and the buttons of a touch screen show. */
function paintThumbs({ cockpit: { flight }, devices: { thumbs }, live }: Parts): void {
  const isFlownByIt = live.flightControls.autopilot.isOn();
  thumbs.show(flight.known ? flight.throttle : 0, flight.hover);
  thumbs.mark('rateDamping', flight.damping);
  thumbs.mark('modeUpright', flight.mode === 'radial' && !isFlownByIt);
  thumbs.mark('autopilot', isFlownByIt);
}
