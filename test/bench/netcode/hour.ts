import { createPredictor } from '../../../src/prediction';
import { BODIES, DEFAULT_SETTINGS, SHIP_CLASSES } from '../../../src/dynamics';
import { createAuthority } from '../../../src/authority';
import { loadScenario } from '../../../src/scenarios';
import { scenarioNamed, value } from '../../prediction/rig';
import type { BodyState, ServerFrame } from '../../../src/wire';
import type { Figure } from './figure';

const HOUR = 3600;
/** Error of the server's clock, s: its bodies are that much earlier or later on their way. */
const CLOCK_ERROR = 0.05;

/** A ship at rest on Earth's equator for an hour, on a server whose ground is 23 m away from the client's. */
export function* hourFigures(): Generator<Figure> {
  const earth = BODIES.find(({ name }) => name === 'Earth')!;
  const scenario = {
    ...scenarioNamed('settle-earth'),
    terrain: 'flat',
    site: { latitude: 0, longitude: 40 },
  };
  const loaded = value(
    loadScenario({
      ...scenario,
      initial: { ...scenario.initial, height: 0.5, velocity: [0, 0, -1], tilt: 0 },
    }),
  );
  const authority = value(
    createAuthority({
      shipClasses: SHIP_CLASSES,
      bodies: [earth],
      terrain: 'flat',
      terrains: { flat: loaded.terrainHeight },
      tickRate: 1,
      timeScale: 1,
    }),
  );
  authority.spawn({ shipId: 'ship-1', playerId: 'me', name: 'Own', ship: loaded.ship });
  const predictor = createPredictor();
  const hello = value(authority.join('me', 'ship-1'))!;
  predictor.receive({ ...hello, settings: DEFAULT_SETTINGS }, 0);
  const before = { corrections: 0, substeps: 0 };
  const total = () => {
    const { diagnosis: d } = predictor.view(0);
    const corrections =
      d.correctionsMismatch + d.correctionsLateInput + d.correctionsLostInput + d.correctionsOtherPilot;
    return { corrections, substeps: d.steppedSubsteps + d.replayedSubsteps };
  };
  for (let second = 1; second <= HOUR + 20; second++) {
    authority.tick(second);
    const frame = authority.frameFor('me')!;
    predictor.receive(second % 2 === 0 ? frame : shifted(frame, earth), second + 0.05);
    for (let i = 0; i < 5; i++) predictor.advance(null, second + 0.05 + i / 5);
    if (second === 20) Object.assign(before, total());
  }
  const after = total();
  const state = predictor.view(0).own?.surfaceContactState ?? 'missing';
  const note = `an hour at Earth’s equator, ${CLOCK_ERROR * 1000} ms of clock error in every other frame; it is ${state}`;
  const corrections = after.corrections - before.corrections;
  const substeps = after.substeps - before.substeps;
  const landed = state === 'landed';
  yield {
    name: 'landed and agreeing: corrections',
    unit: '',
    value: corrections,
    target: '0',
    met: landed && corrections === 0,
    note,
  };
  yield {
    name: 'landed and agreeing: substeps',
    unit: '',
    value: substeps,
    target: '0',
    met: landed && substeps === 0,
  };
}

/** The frame of a server whose clock is off: the body and everything on it are turned by the error. */
function shifted(frame: ServerFrame, { angularVelocity }: Pick<BodyState, 'angularVelocity'>): ServerFrame {
  // About the body's pole; the angle is so small that it equals its sine to 1e-18.
  const [x, y, z] = angularVelocity.map((each) => (each * CLOCK_ERROR) / 2) as unknown as Vec3;
  const turn = [x, y, z, Math.sqrt(1 - x * x - y * y - z * z)] as const;
  return {
    ...frame,
    bodies: frame.bodies.map((body) => ({ ...body, attitude: compose(turn, body.attitude) })),
    ships: frame.ships.map((ship) => {
      const relativePosition = rotate(turn, ship.relativePosition!);
      const centre = frame.bodies[0]!.position;
      return {
        ...ship,
        relativePosition,
        relativeVelocity: rotate(turn, ship.relativeVelocity!),
        position: [0, 1, 2].map((k) => centre[k]! + relativePosition[k]!) as unknown as typeof ship.position,
        attitude: compose(turn, ship.attitude),
      };
    }),
  };
}

type Quat = readonly [number, number, number, number];
type Vec3 = readonly [number, number, number];

function rotate([x, y, z, w]: Quat, [vx, vy, vz]: Vec3): Vec3 {
  const [tx, ty, tz] = [2 * (y * vz - z * vy), 2 * (z * vx - x * vz), 2 * (x * vy - y * vx)];
  return [vx + w * tx + y * tz - z * ty, vy + w * ty + z * tx - x * tz, vz + w * tz + x * ty - y * tx];
}

function compose([ax, ay, az, aw]: Quat, [bx, by, bz, bw]: Quat): Quat {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by + ay * bw + az * bx - ax * bz,
    aw * bz + az * bw + ax * by - ay * bx,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}
