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
  readonly tone: BiquadFilterNode;
  readonly thrusters: GainNode;
}

/** Seconds of noise that repeat. */
const NOISE_SECONDS = 2;
/** s: loudness follows within this, so that nothing clicks. */
const EASE = 0.05;
/** Seconds between two beeps of the alarm, and how late a burn sets it off. */
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
      voices.master.gain.setTargetAtTime(on ? 0.5 : 0, voices.context.currentTime, EASE);
      void (on ? voices.context.resume() : voices.context.suspend());
      return true;
    },
    follow(ship, flight, aids) {
      if (voices === null || !isOn) return;
      const { context, engine, tone, thrusters } = voices;
      const now = context.currentTime;
      const burning = ship !== null && flight.known && ship.fuel > 0;
      const throttle = burning ? flight.throttle : 0;
      engine.gain.setTargetAtTime(throttle === 0 ? 0 : 0.15 + 0.6 * Math.sqrt(throttle), now, EASE);
      tone.frequency.setTargetAtTime(90 + 500 * throttle, now, EASE);
      const { rotationInput, translationInput } = ship?.controls ?? {};
      const pushes = [...(rotationInput ?? []), ...(translationInput ?? [])].some((v) => v !== 0);
      thrusters.gain.setTargetAtTime(burning && pushes ? 0.12 : 0, now, 0.02);
      const next = ship?.shownState ?? '';
      if (next !== state && (next === 'contact' || next === 'crashed'))
        thump(voices, next === 'crashed' ? 1 : Math.min(1, 0.2 + (ship?.impactSpeed ?? 0) / 15));
      state = next;
      if (!aids.shown || !(aids.burnSeconds < LATE) || aids.corridor !== 'fast' || now < beepAt) return;
      beepAt = now + BEEP_EVERY;
      beep(voices);
    },
  };
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
    hiss.frequency.value = 2500;
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

function thump({ context, master }: Voices, loudness: number): void {
  tone(context, master, { type: 'sine', from: 90, to: 30, seconds: 0.35, loudness });
}

function beep({ context, master }: Voices): void {
  tone(context, master, { type: 'square', from: 880, to: 880, seconds: 0.12, loudness: 0.12 });
}

interface Tone {
  readonly type: OscillatorType;
  /** Hz */
  readonly from: number;
  readonly to: number;
  readonly seconds: number;
  readonly loudness: number;
}

function tone(context: AudioContext, to: AudioNode, { type, from, to: end, seconds, loudness }: Tone): void {
  const source = context.createOscillator();
  const gain = context.createGain();
  const now = context.currentTime;
  source.type = type;
  source.frequency.setValueAtTime(from, now);
  source.frequency.exponentialRampToValueAtTime(end, now + seconds);
  gain.gain.setValueAtTime(loudness, now);
  gain.gain.exponentialRampToValueAtTime(0.001, now + seconds);
  source.connect(gain).connect(to);
  source.start(now);
  source.stop(now + seconds);
}
