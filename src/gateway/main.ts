import { runProcess } from './process';

await runProcess(process, console);
