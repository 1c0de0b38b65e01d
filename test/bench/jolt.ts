import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { type Figure, timed } from './measure';

/** Fetched on demand: only this figure needs it. */
const VERSION = '1.1.0';
const BOXES = 1000;

/**
 * Cost of a general engine per body and step: Jolt, 1,000 unit boxes at rest on a plane, none asleep, 60 Hz.
 * Null, with a printed reason, if it cannot be fetched.
 */
export async function joltBody(): Promise<Figure | null> {
  const folder = join('node_modules/.cache/touchdown/jolt', VERSION);
  const entry = join(folder, 'node_modules/jolt-physics/dist/jolt-physics.wasm-compat.js');
  if (!existsSync(entry)) {
    mkdirSync(folder, { recursive: true });
    const arguments_ = ['install', '--no-save', '--prefix', folder, `jolt-physics@${VERSION}`];
    const npm = spawnSync('npm', arguments_, { encoding: 'utf8', shell: process.platform === 'win32' });
    if (npm.status !== 0) {
      console.error(
        `jolt-body: left out, jolt-physics@${VERSION} could not be fetched: ${npm.stderr.trim()}`,
      );
      return null;
    }
  }
  const { default: start } = (await import(pathToFileURL(entry).href)) as { default: () => Promise<unknown> };
  const world = boxesOnPlane(await start());
  return timed('jolt-body', 30, BOXES, (times) => {
    for (let i = 0; i < times; i++) world.Step(1 / 60, 1);
  });
}

interface JoltWorld {
  Step(seconds: number, collisionSteps: number): void;
}

/* The binding is fetched at run time, so its types are not available and the calls below are untyped. */
/* eslint-disable @typescript-eslint/no-explicit-any, @typescript-eslint/no-unsafe-assignment, @typescript-eslint/no-unsafe-member-access, @typescript-eslint/no-unsafe-call */
function boxesOnPlane(J: any): JoltWorld {
  const settings = new J.JoltSettings();
  const layers = new J.ObjectLayerPairFilterTable(2);
  layers.EnableCollision(0, 1);
  layers.EnableCollision(1, 1);
  const broad = new J.BroadPhaseLayerInterfaceTable(2, 2);
  broad.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
  broad.MapObjectToBroadPhaseLayer(1, new J.BroadPhaseLayer(1));
  settings.mObjectLayerPairFilter = layers;
  settings.mBroadPhaseLayerInterface = broad;
  settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(broad, 2, layers, 2);
  settings.mMaxWorkerThreads = 0;
  const world = new J.JoltInterface(settings);
  const bodies = world.GetPhysicsSystem().GetBodyInterface();
  const upright = new J.Quat(0, 0, 0, 1);
  const plane = new J.PlaneShapeSettings(new J.Plane(new J.Vec3(0, 1, 0), 0)).Create().Get();
  const ground = new J.BodyCreationSettings(plane, new J.RVec3(0, 0, 0), upright, J.EMotionType_Static, 0);
  bodies.CreateAndAddBody(ground, J.EActivation_DontActivate);
  const box = new J.BoxShape(new J.Vec3(0.5, 0.5, 0.5), 0.05);
  for (let i = 0; i < BOXES; i++) {
    const place = new J.RVec3((i % 32) * 2, 0.5, Math.floor(i / 32) * 2);
    const creation = new J.BodyCreationSettings(box, place, upright, J.EMotionType_Dynamic, 1);
    creation.mAllowSleeping = false;
    bodies.CreateAndAddBody(creation, J.EActivation_Activate);
  }
  return world as JoltWorld;
}
