import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { heightmapTerrain } from '../../src/dynamics';
import { valueOf } from '../authority/moon';
import { startOperator } from './operator';
import { startPilot } from './pilot';

const WORLD = 'src/service/touchdown_service/world.json';
const [COLUMNS, ROWS] = [128, 64];
const GRID = { columns: COLUMNS, rows: ROWS, scale: 0.5, interpolation: 'bicubic' } as const;
/** m */
const REFERENCE_RADIUS = 1_737_900;
const BODY_RADIUS = 1_737_400;

/** Ridges 2 km high, 60 km from crest to valley. */
const samples = Int16Array.from({ length: COLUMNS * ROWS }, (_, i) =>
  Math.round(2000 * Math.sin(0.8 * (i % COLUMNS)) * Math.cos(0.7 * Math.floor(i / COLUMNS))),
);

it('lands on a heightmap that the world file names, on the same ground as a client that has the map', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'touchdown-heightmap-'));
  writeFileSync(join(folder, 'luna.i16'), new Uint8Array(samples.buffer));
  const heightmaps = { Luna: { ...GRID, path: 'luna.i16', reference_radius: REFERENCE_RADIUS } };
  const world = { ...(JSON.parse(readFileSync(WORLD, 'utf8')) as object), terrain: 'surveyed', heightmaps };
  writeFileSync(join(folder, 'world.json'), JSON.stringify(world));
  const surveyed = valueOf(
    heightmapTerrain({
      Luna: { ...GRID, samples, referenceRadius: REFERENCE_RADIUS, bodyRadius: BODY_RADIUS },
    }),
  );
  const operator = await startOperator('no', ['--world', join(folder, 'world.json')]);
  const pilot = startPilot(await operator.addressOf('one', 'stream'), { terrains: { surveyed } });
  try {
    await operator.set('game:tick_rate', '10');
    await operator.drop('one', 40, 8);
    await pilot.fly((view) => view.own?.surfaceContactState === '');
    const { correctionsMismatch: before } = pilot.view().diagnosis;
    await pilot.fly((view) => view.own?.shownState === 'landed' && view.own.provenance === 'confirmed');
    const { own, diagnosis } = pilot.view();
    expect(diagnosis.correctionsMismatch - before, diagnosis.lastMismatch).toBe(0);
    expect(diagnosis.groundOffset).toBe(0);
    // The ground at the site is hundreds of metres from the sphere; otherwise flat ground would agree too.
    const height = Math.hypot(...own!.position) - BODY_RADIUS;
    expect(Math.abs(height)).toBeGreaterThan(100);
    expect(pilot.trouble).toEqual([]);
  } finally {
    pilot.dispose();
    await operator.stop();
    rmSync(folder, { recursive: true, force: true });
  }
});
