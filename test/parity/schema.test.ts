/** The format of parity files, field by field: schema, reader and README agree. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Ajv } from 'ajv';
import { describe, expect, it } from 'vitest';
import { parityLine } from './parityLine';

const FOLDERS = ['../parity/fixtures', '../service/fixtures'].map((path) => join(import.meta.dirname, path));
const schema = JSON.parse(readFileSync(join(import.meta.dirname, 'fixture.schema.json'), 'utf8')) as object;
const validate = new Ajv({ allErrors: true, allowUnionTypes: true }).compile(schema);
const files = FOLDERS.flatMap((folder) =>
  readdirSync(folder)
    .filter((name) => name.endsWith('.json'))
    .map((name) => join(folder, name)),
);
const text = readFileSync(
  files.find((file) => file.endsWith('firm-settle.json'))!,
  'utf8',
);

interface Trajectory {
  body: Record<string, unknown>;
  initial: Record<string, unknown>;
  states: Record<string, unknown>[];
  ship_class: Record<string, unknown>;
  [name: string]: unknown;
}
const trajectory = () => JSON.parse(text) as Trajectory;

/** A record as HGETALL returns it: strings, quaternions [w, x, y, z]. */
function asHash(record: Record<string, unknown>): Record<string, unknown> {
  const { attitude, impact_speed: impact, ...rest } = record;
  delete rest['crashed'];
  const [x, y, z, w] = attitude as number[];
  const told = {
    ...rest,
    attitude: [w, x, y, z],
    ...(impact !== undefined && { contact_impact_speed: impact }),
  };
  const texts = Object.entries(told).map(([name, value]) => [
    name,
    typeof value === 'string' ? value : JSON.stringify(value),
  ]);
  return Object.fromEntries(texts) as Record<string, unknown>;
}

describe('the schema', () => {
  it('accepts every fixture of the repository', () => {
    expect(files.length).toBeGreaterThan(40);
    const refused = files.filter((file) => !validate(JSON.parse(readFileSync(file, 'utf8'))));
    expect(refused).toEqual([]);
  });

  it('describes each field', () => {
    const bare: string[] = [];
    const visit = (node: unknown, path: string): void => {
      if (typeof node !== 'object' || node === null) return;
      const { properties } = node as { properties?: Record<string, { description?: string; $ref?: string }> };
      for (const [name, field] of Object.entries(properties ?? {}))
        if ((field.description ?? '') === '' && field.$ref === undefined) bare.push(`${path}.${name}`);
      for (const [key, child] of Object.entries(node)) visit(child, `${path}.${key}`);
    };
    visit(schema, '');
    expect(bare).toEqual([]);
  });

  it.each([
    ['a state without fuel', (file: Trajectory) => delete file.states[2]!['fuel']],
    ['a string for a number', (file: Trajectory) => (file.ship_class['dry_mass'] = '8000')],
    ['a vector of two', (file: Trajectory) => (file.body['position'] = [1, 2])],
    ['no states', (file: Trajectory) => (file.states = [])],
    ['a state that is none', (file: Trajectory) => (file.states[0]!['surface_contact_state'] = 'LANDED')],
  ])('refuses what the reader refuses: %s', (_what, spoil) => {
    const file = trajectory();
    spoil(file);
    expect(validate(file)).toBe(false);
    expect(parityLine('file.json', JSON.stringify(file)).passed).toBe(false);
  });
});

describe('npm run parity', () => {
  it('lists every fault of a file at once, one per line', () => {
    const file = trajectory();
    delete file.ship_class['dry_mass'];
    file.body['position'] = 'here';
    file.states[1]!['fuel'] = null;
    file['config'] = { gravity: 1 };
    const { line, passed } = parityLine('file.json', JSON.stringify(file));
    expect(passed).toBe(false);
    expect(line.split('\n').slice(1)).toEqual([
      '  config.gravity: no such setting',
      '  ship_class.dry_mass: expected a finite number, got nothing',
      "  body.position: expected 3 numbers, got 'here'",
      '  states[1].fuel: expected a finite number, got null',
    ]);
  });

  it('expects inputs in the order of their substeps, and texts of at most 1,000 characters', () => {
    const file = trajectory();
    const controls = { attitude_mode: 'none' };
    file['inputs'] = [4, 4, 3].map((substep) => ({ tick: 1, substep, ...controls }));
    file['name'] = 'x'.repeat(1000);
    const line = () => parityLine('file.json', JSON.stringify(file)).line;
    expect(line()).toBe('file.json: inputs[2].substep: expected in ascending order of time');
    file['inputs'] = [{ tick: 1.5, substep: 0 }];
    expect(line()).toBe('file.json: inputs[0].tick: expected a whole number ≥ 0, got 1.5');
    file['inputs'] = [];
    expect(line()).not.toContain('name:');
    file['name'] = 'x'.repeat(1001);
    expect(line()).toBe(
      'file.json: name: expected a string of at most 1000 characters, got a string of 1001',
    );
  });

  it.each([
    [true, 'true'],
    [{ kg: 1 }, 'an object'],
    [[1, 2], 'a list of 2'],
    ['x'.repeat(40), `'${'x'.repeat(40)}'`],
    ['x'.repeat(41), 'a string of 41'],
  ])('says what it found in place of a number: %j', (found, said) => {
    const file = trajectory();
    file.states[1]!['fuel'] = found;
    const { line } = parityLine('file.json', JSON.stringify(file));
    expect(line).toContain(`states[1].fuel: expected a finite number, got ${said}`);
  });

  it('reports a missing object once, and not its contents', () => {
    const { line } = parityLine('file.json', '{"states": 7}');
    expect(line).toContain('body: expected an object, got nothing');
    expect(line).not.toContain('body.mass');
    expect(parityLine('file.json', '[]').line).toBe('file.json: file: expected an object, got a list of 0');
  });

  it('prints both values of what is out of tolerance', () => {
    const file = trajectory();
    file.states[1]!['fuel'] = 1234.5;
    expect(parityLine('file.json', JSON.stringify(file)).line).toMatch(
      /OUT OF TOLERANCE: fuel from tick \d+: here [\d.]+, in the file 1234.5$/,
    );
  });

  it('accepts Redis hashes of strings, and quaternions with w first', () => {
    const file = trajectory();
    const redis = {
      ...file,
      body: asHash(file.body),
      initial: asHash(file.initial),
      states: file.states.map(asHash),
    };
    expect(validate(redis)).toBe(true);
    const line = (given: object) => parityLine('file.json', JSON.stringify(given)).line;
    expect(line(redis)).toBe(line(file));
    expect(parityLine('file.json', JSON.stringify(redis)).passed).toBe(true);
  });
});
