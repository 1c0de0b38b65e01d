/** The synthesised sounds at each moment of a flight, in an audio context that records its calls. */
import { expect, it, vi } from 'vitest';
import { createSound } from '../../../src/playground/sound/sound';
import {
  createFlightReadout,
  createLandingAids,
  type FlightReadout,
  type LandingAids,
} from '../../../src/readout';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import type { ShipView } from '../../../src/prediction';
import { makeShip } from '../../readout/views';

/** A node of the audio, and where its sound goes. */
interface Noted {
  readonly name: string;
  to: string;
  type: string;
  loop: boolean;
  buffer: { data: Float32Array; rate: number } | null;
  readonly gain: { value: number };
  readonly frequency: { value: number };
  readonly connect: (to: Noted) => Noted;
  readonly start: (at?: number) => void;
  readonly stop: (at: number) => void;
}

/** A window whose audio records its nodes and the changes of their parameters. */
function createAudio() {
  const told: string[] = [];
  const param = (name: string) => ({
    value: NaN,
    setTargetAtTime: (value: number, at: number, ease: number) =>
      told.push(`${name} ${value.toFixed(3)} from ${String(at)} s within ${String(ease)} s`),
    setValueAtTime: (value: number, at: number) => told.push(`${name} ${String(value)} at ${String(at)} s`),
    exponentialRampToValueAtTime: (value: number, at: number) =>
      told.push(`${name} to ${String(value)} at ${at.toFixed(2)} s`),
  });
  const nodes: Record<string, Noted[]> = {};
  const createNode = (kind: string): Noted => {
    const same = (nodes[kind] ??= []);
    const name = `${kind} ${String(same.length)}`;
    const node: Noted = {
      ...{ name, type: '', loop: false, to: '', buffer: null, gain: param(name), frequency: param(name) },
      connect(to) {
        node.to = to.name;
        return to;
      },
      start: (at) => told.push(`${name} starts${at === undefined ? '' : ` at ${String(at)} s`}`),
      stop: (at) => told.push(`${name} stops at ${at.toFixed(2)} s`),
    };
    same.push(node);
    return node;
  };
  const context = {
    ...{ currentTime: 10, sampleRate: 100, destination: { name: 'speakers' } },
    createGain: () => createNode('gain'),
    createBiquadFilter: () => createNode('filter'),
    createBufferSource: () => createNode('noise'),
    createOscillator: () => createNode('tone'),
    createBuffer: (channels: number, length: number, rate: number) => {
      const data = new Float32Array(length * channels);
      return { data, rate, getChannelData: () => data };
    },
    resume: () => told.push('resume'),
    suspend: () => told.push('suspend'),
  };
  const AudioContext = function () {
    return context;
  };
  return { window: { AudioContext } as unknown as Window, context, nodes, take: () => told.splice(0) };
}

const PUSHING = { ...NEUTRAL_CONTROLS, translationInput: [0, 0, 0.1] as const };
const TURNING = { ...NEUTRAL_CONTROLS, rotationInput: [0, -1, 0] as const };

/** Sound switched on, and a function that passes it a frame. */
function createOn() {
  const audio = createAudio();
  const sound = createSound(audio.window);
  sound.set(true);
  audio.take();
  return {
    ...audio,
    sound,
    hear: (
      ship: Partial<ShipView> | null,
      flight: Partial<FlightReadout> = {},
      aids: Partial<LandingAids> = {},
    ) => {
      sound.follow(
        ship === null ? null : makeShip({}, ship),
        { ...createFlightReadout(), known: true, throttle: 0, ...flight },
        { ...createLandingAids(), ...aids },
      );
      return audio.take();
    },
  };
}

it('is silent and opens nothing until it is switched on, and can be switched off', () => {
  const { window, nodes, take } = createAudio();
  const sound = createSound(window);
  sound.follow(null, createFlightReadout(), createLandingAids());
  expect([sound.isOn(), sound.set(false), sound.isOn(), Object.keys(nodes), take()]).toEqual([
    ...[false, false, false, [], []],
  ]);
  expect([sound.set(true), sound.isOn()]).toEqual([true, true]);
  expect(take()).toEqual(['noise 0 starts', 'gain 0 0.500 from 10 s within 0.05 s', 'resume']);
  expect(sound.set(true)).toBe(true);
  expect(nodes['noise']).toHaveLength(1);
  take();
  expect([sound.set(false), sound.isOn()]).toEqual([true, false]);
  expect(take()).toEqual(['gain 0 0.000 from 10 s within 0.05 s', 'suspend']);
  sound.follow(makeShip({}), createFlightReadout(), createLandingAids());
  expect(take()).toEqual([]);
});

it('stays off in a browser without sound', () => {
  const sound = createSound({} as Window);
  expect([sound.set(true), sound.isOn()]).toEqual([false, false]);
});

it('makes engine and thrusters from two seconds of noise, filtered low and high', () => {
  vi.spyOn(Math, 'random').mockReturnValueOnce(0).mockReturnValueOnce(1);
  const { nodes } = createOn();
  vi.restoreAllMocks();
  const [noise] = nodes['noise']!;
  expect([noise!.buffer!.data.length, noise!.buffer!.rate, noise!.loop]).toEqual([200, 100, true]);
  expect([...noise!.buffer!.data.subarray(0, 2)]).toEqual([-1, 1]);
  expect(nodes['filter']!.map(({ type, to }) => [type, to])).toEqual([
    ['lowpass', 'gain 1'],
    ['highpass', 'gain 2'],
  ]);
  expect(nodes['filter']![1]!.frequency.value).toBe(2500);
  expect(nodes['gain']!.map(({ to, gain }) => [to, gain.value])).toEqual([
    ['speakers', 0],
    ['gain 0', 0],
    ['gain 0', 0],
  ]);
});

it.each<
  readonly [string, Partial<ShipView> | null, Partial<FlightReadout>, readonly [string, string, string]]
>([
  ['a quarter of throttle', {}, { throttle: 0.25 }, ['0.450', '215.000', '0.000']],
  ['full throttle', {}, { throttle: 1 }, ['0.750', '590.000', '0.000']],
  ['no throttle', {}, { throttle: 0 }, ['0.000', '90.000', '0.000']],
  ['pushing', { controls: PUSHING }, {}, ['0.000', '90.000', '0.120']],
  ['turning', { controls: TURNING }, {}, ['0.000', '90.000', '0.120']],
  ['an empty tank', { controls: TURNING, fuel: 0 }, { throttle: 1 }, ['0.000', '90.000', '0.000']],
  ['the last kilogram', { controls: TURNING, fuel: 1 }, {}, ['0.000', '90.000', '0.120']],
  ['an unknown flight', { controls: TURNING }, { known: false, throttle: 1 }, ['0.000', '90.000', '0.000']],
  ['no ship', null, { throttle: 1 }, ['0.000', '90.000', '0.000']],
])('with %s engine and thrusters follow', (_what, ship, flight, [engine, pitch, thrusters]) => {
  const { hear } = createOn();
  expect(hear(ship, flight)).toEqual([
    `gain 1 ${engine} from 10 s within 0.05 s`,
    `filter 0 ${pitch} from 10 s within 0.05 s`,
    `gain 2 ${thrusters} from 10 s within 0.02 s`,
  ]);
});

it('thumps once at a touch, louder for a harder one, loudest at a crash', () => {
  const { hear } = createOn();
  const thumps = (ship: Partial<ShipView> | null) =>
    hear(ship).filter(
      (what) => !what.startsWith('gain 1') && !what.startsWith('gain 2') && !what.startsWith('filter'),
    );
  expect(thumps({ shownState: '' })).toEqual([]);
  expect(thumps({ shownState: 'contact', impactSpeed: 6 })).toEqual([
    'tone 0 90 at 10 s',
    'tone 0 to 30 at 10.35 s',
    expect.stringMatching(/^gain 3 0\.6\d* at 10 s$/),
    'gain 3 to 0.001 at 10.35 s',
    'tone 0 starts at 10 s',
    'tone 0 stops at 10.35 s',
  ]);
  expect(thumps({ shownState: 'contact', impactSpeed: 6 })).toEqual([]);
  expect(thumps({ shownState: 'landed' })).toEqual([]);
  expect(thumps({ shownState: 'contact', impactSpeed: 40 })).toContain('gain 4 1 at 10 s');
  expect(thumps({ shownState: 'crashed', impactSpeed: 3 })).toContain('gain 5 1 at 10 s');
  expect(thumps(null)).toEqual([]);
  expect(thumps({ shownState: 'tipped' })).toEqual([]);
});

it('beeps twice a second while a fast descent must be braked within 1.5 s', () => {
  const late = { shown: true, burnSeconds: 1.4, corridor: 'fast' } as const;
  const { hear, nodes, context } = createOn();
  const beeps = (aids: Partial<LandingAids>) => {
    const before = nodes['tone']?.length ?? 0;
    hear({}, {}, aids);
    return (nodes['tone']?.length ?? 0) - before;
  };
  const calm = [{ shown: false }, { burnSeconds: 1.5 }, { burnSeconds: NaN }, { corridor: 'good' as const }];
  expect(calm.map((change) => beeps({ ...late, ...change }))).toEqual([0, 0, 0, 0]);
  const times = [10, 10.4, 10.5, 10.9, 11];
  expect(times.map((now) => ((context.currentTime = now), beeps(late)))).toEqual([1, 0, 1, 0, 1]);
  expect(nodes['tone']!.map(({ type }) => type)).toEqual(['square', 'square', 'square']);
  context.currentTime = 20;
  expect(hear({}, {}, late).slice(3)).toEqual([
    'tone 3 880 at 20 s',
    'tone 3 to 880 at 20.12 s',
    'gain 6 0.12 at 20 s',
    'gain 6 to 0.001 at 20.12 s',
    'tone 3 starts at 20 s',
    'tone 3 stops at 20.12 s',
  ]);
});
