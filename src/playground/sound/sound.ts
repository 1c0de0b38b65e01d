import type { FlightReadout, LandingAids } from '../../readout';
import type { ShipView } from '../../prediction';

/** Engine, thrusters, touch and alarm, synthesised. Silent until switched on. */
export interface Sound {
  readonly isOn: () => boolean;
  /** Switches it; returns false if the browser has no sound. */
  readonly set: (on: boolean) => boolean;
  /** Once a frame. */
  readonly follow: (ship: ShipView | null, flight: FlightReadout, aids: LandingAids) => void;
}

interface Voices {
  readonly context: AudioContext;
  readonly master: GainNode;
  readonly engine: GainNode;
  /** Low-pass filter of the engine's noise. */
  readonly tone: BiquadFilterNode;
  readonly thrusters: GainNode;
}

/** Seconds of noise that repeat. */
const NOISE_SECONDS = 2;
/** s: gains change within this, so that nothing clicks; thrusters fire in shorter pulses. */
const EASE = 0.05;
const THRUSTER_EASE = 0.02;
/** Gains, 0 … 1. The ear hears ratios, so that of the engine grows with the root of the throttle. */
const MASTER_GAIN = 0.5;
const THRUSTER_GAIN = 0.12;
const engineGain = (throttle: number): number => (throttle === 0 ? 0 : 0.15 + 0.6 * Math.sqrt(throttle));
/** Hz above which the engine's noise is cut off: brighter at full throttle. */
const engineTone = (throttle: number): number => 90 + 500 * throttle;
/** Hz below which the thrusters' noise is cut off. */
const HISS_FROM = 2500;
/** Loudness of a touch at `speed`, m/s: 0 … 1. */
const touchLoudness = (speed: number): number => Math.min(1, 0.2 + speed / 15);
/** Seconds between two beeps of the alarm, and the time before the latest braking at which it begins, s. */
const BEEP_EVERY = 0.5;
const LATE = 1.5;

export function createSound(window: Window): Sound {
  let voices: Voices | null = null;
  let isOn = false;
  let state = '';
  let beepAt = 0;
  return {
    isOn: () => isOn,
    set(on) {
      voices ??= on ? openVoices(window) : null;
      if (voices === null) return false;
      isOn = on;
      voices.master.gain.setTargetAtTime(on ? MASTER_GAIN : 0, voices.context.currentTime, EASE);
      void (on ? voices.context.resume() : voices.context.suspend());
      return true;
    },
    follow(ship, flight, aids) {
      if (voices === null || !isOn) return;
      const now = voices.context.currentTime;
      followDrives(voices, flight.known && ship !== null && ship.fuel > 0 ? ship : null, flight.throttle);
      const next = ship?.shownState ?? '';
      if (next !== state && next === 'contact') thump(voices, touchLoudness(ship?.impactSpeed ?? 0));
      if (next !== state && next === 'crashed') thump(voices, 1);
      state = next;
      if (!isBrakingLate(aids) || now < beepAt) return;
      beepAt = now + BEEP_EVERY;
      beep(voices);
    },
  };
}

function isBrakingLate({ shown, burnSeconds, corridor }: LandingAids): boolean {
  return shown && burnSeconds < LATE && corridor === 'fast';
}

/** @param ship null: without fuel, or unknown; nothing burns */
function followDrives(voices: Voices, ship: ShipView | null, throttle: number): void {
  const { context, engine, tone, thrusters } = voices;
  const now = context.currentTime;
  const share = ship === null ? 0 : throttle;
  engine.gain.setTargetAtTime(engineGain(share), now, EASE);
  tone.frequency.setTargetAtTime(engineTone(share), now, EASE);
  const { rotationInput = [], translationInput = [] } = ship?.controls ?? {};
  const isPushing = [...rotationInput, ...translationInput].some((value) => value !== 0);
  thrusters.gain.setTargetAtTime(isPushing ? THRUSTER_GAIN : 0, now, THRUSTER_EASE);
}

/** Null where there is no Web Audio, or none left. */
function openVoices(window: Window): Voices | null {
  try {
    const context = new (window as Window & typeof globalThis).AudioContext();
    const master = context.createGain();
    master.gain.value = 0;
    master.connect(context.destination);
    const noise = createNoise(context);
    const tone = context.createBiquadFilter();
    tone.type = 'lowpass';
    const engine = gainOf(context, master);
    noise.connect(tone).connect(engine);
    const hiss = context.createBiquadFilter();
    hiss.type = 'highpass';
    hiss.frequency.value = HISS_FROM;
    const thrusters = gainOf(context, master);
    noise.connect(hiss).connect(thrusters);
    noise.start();
    return { context, master, engine, tone, thrusters };
  } catch {
    return null;
  }
}

function gainOf(context: AudioContext, to: AudioNode): GainNode {
  const gain = context.createGain();
  gain.gain.value = 0;
  gain.connect(to);
  return gain;
}

function createNoise(context: AudioContext): AudioBufferSourceNode {
  const buffer = context.createBuffer(1, NOISE_SECONDS * context.sampleRate, context.sampleRate);
  const samples = buffer.getChannelData(0);
  for (let i = 0; i < samples.length; i++) samples[i] = 2 * Math.random() - 1;
  const source = context.createBufferSource();
  source.buffer = buffer;
  source.loop = true;
  return source;
}

/** A low knock. */
function thump({ context, master }: Voices, loudness: number): void {
  tone(context, master, { type: 'sine', from: 90, to: 30, seconds: 0.35, loudness });
}

function beep({ context, master }: Voices): void {
  tone(context, master, { type: 'square', from: 880, to: 880, seconds: 0.12, loudness: 0.12 });
}

/** Gain that is not heard; an exponential ramp cannot end at 0. */
const SILENCE = 0.001;

interface Tone {
  readonly type: OscillatorType;
  /** Hz */
  readonly from: number;
  readonly to: number;
  readonly seconds: number;
  readonly loudness: number;
}

/** A tone that glides from one frequency to another and fades to `SILENCE`. */
function tone(context: AudioContext, to: AudioNode, { type, from, to: end, seconds, loudness }: Tone): void {
  const source = context.createOscillator();
  const gain = context.createGain();
  const now = context.currentTime;
  source.type = type;
  source.frequency.setValueAtTime(from, now);
  source.frequency.exponentialRampToValueAtTime(end, now + seconds);
  gain.gain.setValueAtTime(loudness, now);
  gain.gain.exponentialRampToValueAtTime(SILENCE, now + seconds);
  source.connect(gain).connect(to);
  source.start(now);
  source.stop(now + seconds);
}
