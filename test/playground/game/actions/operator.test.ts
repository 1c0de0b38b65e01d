/** The operator's commands: what each does to server, page and score. */
import { afterEach, describe, expect, it, vi } from 'vitest';
import { createOperatorActions } from '../../../../src/playground/game/actions/operatorActions';

describe('the operator', () => {
  afterEach(() => void vi.useRealTimers());

  /** The operator's commands, and all that they set in motion. */
  function createOperator({ server = '', replay = null as object | null } = {}) {
    const done: string[] = [];
    const note =
      (what: string) =>
      (...given: unknown[]) =>
        done.push([what, ...given.map((g) => JSON.stringify(g))].join(' '));
    let isDragged = false;
    const operator = createOperatorActions({
      live: {
        ...{ operate: note('operate'), suspend: note('suspend'), reconnect: note('reconnect') },
        steer: note('steer'),
        flightControls: { setPaused: note('paused'), save: () => 'half', restore: note('controls') },
      },
      panel: { press: note('press'), label: note('label') },
      banner: { flash: note('flash'), state: note('state') },
      choices: () => ({ server }),
      markIntervention: note('intervention'),
      toggleDrag: () => (isDragged = !isDragged),
      deck: { replay: () => replay },
    } as never);
    const take = () => done.splice(0);
    return {
      operator,
      take,
      does: (name: keyof typeof operator) => ((operator[name] as () => void)(), take()),
    };
  }

  it('pauses, steps and resumes', () => {
    const { does } = createOperator();
    const words = 'Paused: the server stops at its next tick. O steps one substep.';
    const pausing = ['press "pause" true', 'label "pause" "Resume"', 'paused true'];
    const paused = [...pausing, 'operate {"kind":"pause","paused":true}', `state "${words}"`];
    const stepped = ['intervention "it was stepped"', 'operate {"kind":"step","unit":"substep"}'];
    expect(does('stepSubstep')).toEqual([...paused, ...stepped]);
    expect(does('stepSubstep')).toEqual(stepped);
    expect(does('pause')).toEqual([
      ...['press "pause" false', 'label "pause" "Pause"', 'paused false'],
      ...['operate {"kind":"pause","paused":false}', 'state ""'],
    ]);
  });

  it('breaks the network: a spike, a frozen server, a dropped connection', () => {
    const { does } = createOperator();
    expect(does('spike')).toEqual([
      ...['operate {"kind":"spike","seconds":1.5}', 'flash "Lag spike: nothing arrives for 1.5 s."'],
    ]);
    expect(does('freeze')).toEqual(['press "freeze" true', 'operate {"kind":"freeze","frozen":true}']);
    expect(does('freeze')).toEqual(['press "freeze" false', 'operate {"kind":"freeze","frozen":false}']);
    expect(does('drop')).toEqual([
      'press "drop" true',
      'label "drop" "Reconnect"',
      'operate {"kind":"drop"}',
    ]);
    expect(does('drop')).toEqual(['press "drop" false', 'label "drop" "Drop the connection"', 'reconnect']);
  });

  it('hides the page for a minute of wall time, or until it is back', () => {
    vi.useFakeTimers();
    const { operator, take, does } = createOperator();
    const from = performance.now() / 1000;
    expect(does('away')).toEqual(['press "away" true', 'suspend true']);
    operator.tick(from + 0.5);
    const [words, label] = take();
    expect(words).toMatch(/^state "Simulating a hidden tab: nothing received or drawn for 60 s\."$/);
    expect(label).toBe('label "away" "Back now (60 s)"');
    const back = ['press "away" false', 'suspend false', 'label "away" "Hide for a minute"', 'state ""'];
    operator.tick(from + 62);
    expect(take()).toEqual(back);
    operator.tick(from + 63);
    expect(take()).toEqual([]);
    does('away');
    expect(does('away')).toEqual(back);
  });

  it('kicks, saves, restores and moves the ship, and such a flight is not scored', () => {
    const { does } = createOperator();
    expect(does('kick')).toEqual([
      ...[
        'intervention "the ship was kicked"',
        'operate {"kind":"kick","velocity":[2,0,3],"spin":[0,0.35,0]}',
      ],
    ]);
    const restored = ['intervention "a snapshot was restored"', 'operate {"kind":"restore"}'];
    // The server refuses: there is no snapshot.
    expect(does('restore')).toEqual(restored);
    expect(does('snapshot')[0]).toBe('operate {"kind":"snapshot"}');
    expect(does('restore')).toEqual([...restored, 'controls "half"', 'steer']);
    does('reset');
    expect(does('restore')).toEqual(restored);
    expect(does('drag').slice(0, 2)).toEqual(['press "drag" true', 'intervention "the ship was moved"']);
    expect(does('drag')).toEqual(['press "drag" false', 'flash "Dragging turns the camera again."']);
  });

  it('does nothing on a real server’s time or while a recording plays, and reports why', () => {
    const remote = createOperator({ server: 'ws://game' });
    const refused = ['flash "Only available with the built-in server."'];
    expect([remote.does('pause'), remote.does('stepSubstep')]).toEqual([refused, refused]);
    const replaying = createOperator({ replay: {} });
    const plays = ['flash "A recording is playing: go back to the game first."'];
    expect([replaying.does('kick'), replaying.does('pause'), replaying.does('away')]).toEqual([
      plays,
      plays,
      plays,
    ]);
  });

  it('is reset in a new world', () => {
    const { does } = createOperator();
    for (const name of ['pause', 'freeze', 'drop', 'away'] as const) does(name);
    expect(does('reset')).toEqual([
      'suspend false',
      ...['pause', 'freeze', 'drop', 'away'].map((name) => `press "${name}" false`),
      ...['label "pause" "Pause"', 'label "drop" "Drop the connection"', 'label "away" "Hide for a minute"'],
    ]);
    expect(does('pause')[0]).toBe('press "pause" true');
    expect(does('drop')[0]).toBe('press "drop" true');
  });
});
