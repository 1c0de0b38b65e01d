import { absenceFigures } from './netcode/absence';
import { print } from './netcode/figure';
import { lawFigures } from './netcode/flights/law';
import { clockFigures } from './netcode/flights/clock';
import { costFigures } from './netcode/cost';
import { faultFigures } from './netcode/faults';
import { fleetFigures } from './netcode/flights/fleet';
import { soakFigures } from './netcode/soak';
import { foreignFigures } from './netcode/foreign/foreign';
import { hourFigures } from './netcode/hour';
import { stateFigures } from './netcode/flights/states';
import { smoothnessFigures } from './netcode/flights/smoothness';

const asJson = process.argv.includes('--json');
let missed = 0;
// Costs first: a game has one terrain, and once the compiler has seen several, their calls are no longer inlined.
for (const figures of [
  costFigures(),
  absenceFigures(),
  soakFigures(),
  lawFigures(),
  clockFigures(),
  smoothnessFigures(),
  fleetFigures(),
  stateFigures(),
  hourFigures(),
  faultFigures(),
  foreignFigures(),
]) {
  for (const figure of figures) {
    print(figure, asJson);
    if (!figure.met) missed += 1;
  }
}
if (!asJson) console.log(missed === 0 ? 'all targets met' : `${missed} targets missed`);
