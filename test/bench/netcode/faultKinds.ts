import type { FaultyLine } from '../../prediction/faults/faultyLine';

export type Fault = (line: FaultyLine, seconds: number) => void;

/** Each fault lasts `seconds` of true time. */
export const FAULTS: Readonly<Record<string, Fault>> = {
  'link held up': hold('up'),
  'link held down': hold('down'),
  'link held': hold('both'),
  'page frozen': (line, seconds) => {
    line.freezePage(seconds);
  },
  'now put on': shiftNow(1),
  'now put back': shiftNow(-1),
  'server standing, pings answered': pause(true),
  'server standing': pause(false),
  'server restarted': (line) => {
    line.restartServer(0);
  },
};

function hold(ways: 'up' | 'down' | 'both'): Fault {
  return (line, seconds) => {
    line.holdLink(seconds, ways);
    line.run(seconds);
  };
}

function pause(answers: boolean): Fault {
  return (line, seconds) => {
    line.pauseServer(seconds, answers);
    line.run(seconds);
  };
}

function shiftNow(sign: number): Fault {
  return (line, seconds) => {
    const { pageClock } = line;
    line.pageClock = (now) => pageClock(now) + sign * seconds;
  };
}
