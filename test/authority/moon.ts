import { expect } from 'vitest';
import { type Authority, type AuthorityOptions, createAuthority } from '../../src/authority';
import {
  BODIES,
  type Controls,
  NEUTRAL_CONTROLS,
  SHIP_CLASSES,
  type ShipInit,
  TERRAINS,
} from '../../src/dynamics';
import { SCENARIOS, loadScenario } from '../../src/scenarios';
import type { InputRecord, ServerFrame } from '../../src/wire';

export const MOON: AuthorityOptions = {
  shipClasses: SHIP_CLASSES,
  bodies: BODIES.filter(({ name }) => name === 'Luna'),
  terrain: 'flat',
  terrains: TERRAINS,
  tickRate: 1,
  timeScale: 1,
};

/** Value of what must have been accepted. */
export function valueOf<T>(checked: { ok: true; value: T } | { ok: false; reason: string }): T {
  if (!checked.ok) throw new Error(checked.reason);
  return checked.value;
}

/** The ship of a scenario at its start. */
export function shipOf(scenario: string): ShipInit {
  return valueOf(loadScenario(SCENARIOS.find(({ name }) => name === scenario)!)).ship;
}

/** An authority over the Moon, with one ship 'own' of player 'ann', who has joined. */
export function moonWith(scenario: string, options: Partial<AuthorityOptions> = {}): Authority {
  const authority = valueOf(createAuthority({ ...MOON, ...options }));
  expect(authority.spawn({ shipId: 'own', playerId: 'ann', name: 'Own', ship: shipOf(scenario) })).toBeNull();
  valueOf(authority.join('ann', 'own'));
  return authority;
}

export function input(seq: number, tick: number, substep: number, controls: Partial<Controls>): InputRecord {
  return { seq, tick, substep, controls: { ...NEUTRAL_CONTROLS, ...controls } };
}

export function frameOf(authority: Authority, playerId = 'ann'): ServerFrame {
  const frame = authority.frameFor(playerId);
  if (frame === null) throw new Error(`${playerId} has not joined`);
  return frame;
}

/** Ticks at 1 Hz until the boundary `tick`, each at its own wall second. */
export function runTo(authority: Authority, tick: number): void {
  while (authority.tickNumber() < tick) authority.tick(authority.tickNumber() + 1);
}
