import { print } from '../bench/netcode/figure';
import { costFigures } from '../bench/netcode/cost';
for (const f of costFigures()) print(f, false);
