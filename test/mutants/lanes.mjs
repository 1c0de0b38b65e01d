// Starts the processes of lane.mjs, and ends one that hangs.
import { execFileSync, fork } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const LANE = fileURLToPath(new URL('lane.mjs', import.meta.url));
/** ms to start a runner, and for pages a browser and a build, on a busy machine. */
const START_LIMIT = 120_000;

/** Groups of processes that an interrupted sampling must not leave. */
const running = new Set();
function end(pid) {
  if (!running.delete(pid)) return;
  const started = startedBy(pid);
  // The whole group: a worker in an endless loop outlives the runner. What tests start is in groups of its own, a Redis and a browser.
  kill(-pid);
  started.forEach(kill);
}

function kill(pid) {
  try {
    process.kill(pid, 'SIGKILL');
  } catch (error) {
    if (error.code !== 'ESRCH') throw error;
  }
}

/** What a process has started, and what that has. */
function startedBy(pid) {
  const table = execFileSync('ps', ['-eo', 'pid=,ppid='], { encoding: 'utf8' }).trim().split('\n');
  const pairs = table.map((line) => line.trim().split(/\s+/).map(Number));
  const below = (parent) => pairs.flatMap(([own, by]) => (by === parent ? [own, ...below(own)] : []));
  return below(pid);
}
process.on('exit', () => [...running].forEach(end));
for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => process.exit(1));

/** The next message of a child; null after `limit` ms or if it ends. */
function messageOf(child, limit) {
  return new Promise((resolve) => {
    const done = (message) => {
      clearTimeout(timer);
      child.removeAllListeners();
      resolve(message);
    };
    const timer = setTimeout(() => done(null), limit);
    child.once('message', done);
    child.once('exit', () => done(null));
  });
}

/** A lane of the project 'node' or 'browser', started when it is first needed; `probes` names the file for reports of what is reached. */
export function createLane(project, probes = '') {
  let child;
  const start = async () => {
    // A test that is skipped would pass.
    const env = { ...process.env, TOUCHDOWN_MUTANT: '', TOUCHDOWN_PROBES: probes, TOUCHDOWN_NO_SKIP: '1' };
    child = fork(LANE, [project], { env, detached: true, stdio: ['ignore', 'ignore', 'inherit', 'ipc'] });
    running.add(child.pid);
    if ((await messageOf(child, START_LIMIT)) === null)
      throw new Error(`the runner of ${project} does not start`);
  };
  const close = () => {
    if (child) end(child.pid);
    child = undefined;
  };
  return {
    /** Runs test files on the changed source; null where that takes more than `limit` ms. */
    async run(tests, mutant, limit) {
      if (!child) await start();
      child.send({ mutant, tests });
      const answer = await messageOf(child, limit);
      if (answer === null) close();
      return answer;
    },
    close,
  };
}
