/** Links, file paths, and cited sections like "DYNAMICS, Actuators" in documents and comments. */
import { basename, dirname, join, normalize } from 'node:path/posix';
import { placeOf } from '../source';
import type { SourceFile } from '../source';

export interface Documents {
  /** By cited name, without ".md": the lower-case headings, and the numbers of its steps. */
  readonly sections: ReadonlyMap<string, ReadonlySet<string>>;
  /** By path: the anchors of its headings. */
  readonly anchors: ReadonlyMap<string, ReadonlySet<string>>;
  readonly hasPath: (path: string) => boolean;
}

const CITED = /(?<![\w/])([A-Z]{3,})(?:\.md)?(?:,| \()\s*["“]?([A-Za-z0-9](?:[^"”.;:()]|:(?=\w))*)/g;
const LINK = /\]\(([^)\s]+)\)/g;
const PATH =
  /(?<![\w./{-]|\]\()(?:src|test|proto|public|\.ci|\.github)\/[\w./-]+\.(?:ts|mjs|js|py|md|json|jsonl|proto|css|html|c|h|sh|yml)\b/g;

/** A heading's anchor, as Markdown hosts derive it. */
function anchorOf(heading: string): string {
  const plain = heading.toLowerCase().replace(/[^\p{L}\p{N} _-]/gu, '');
  return plain.trim().replaceAll(' ', '-');
}

function headingsOf({ text }: SourceFile): string[] {
  return [...text.matchAll(/^#{1,6} +(.+?) *#*$/gm)].map(([, heading]) => heading!.replace(/[`*]/g, ''));
}

/** The names by which a heading may be cited: "### 5. Linear, unless pinned (below)" by its words, those before a bracket, and as step 5. */
function namesOf(heading: string): string[] {
  const [, number, words = ''] = /^(?:(\d+)\. )?(.*)$/.exec(heading.toLowerCase())!;
  const names = [words, words.replace(/ \(.*$/, '')];
  return number === undefined ? names : [...names, `step ${number}`];
}

export function readDocuments(files: readonly SourceFile[], hasPath: (path: string) => boolean): Documents {
  const sections = new Map<string, ReadonlySet<string>>();
  const anchors = new Map<string, ReadonlySet<string>>();
  for (const file of files) {
    const headings = headingsOf(file);
    anchors.set(file.path, new Set(headings.map(anchorOf)));
    const name = basename(file.path, '.md');
    if (name !== name.toUpperCase() || name === 'README') continue;
    const terms = [...file.text.matchAll(/^(?:[-*] |\| )?\*\*(.+?)[.:]?\*\*/gm)].map(([, term]) => term!);
    sections.set(name, new Set([...headings, ...terms].flatMap(namesOf)));
  }
  return { sections, anchors, hasPath };
}

/** A comment's text with its lines joined; each character keeps its offset. */
function flowing(text: string): string {
  return text.replace(/\n[ \t]*(?:\*(?!\/)|\/\/|#)[ \t]?/g, (gap) => ' '.repeat(gap.length));
}

/** Whether the words begin with a section's name. */
function beginsWithSection(words: string, sections: ReadonlySet<string>): boolean {
  const said = words.replace(/\s+/g, ' ').toLowerCase();
  return [...sections].some(
    (section) => said.startsWith(section) && !/^[\p{L}\p{N}]/u.test(said.slice(section.length)),
  );
}

function linkFault(file: SourceFile, target: string, { anchors, hasPath }: Documents): string | null {
  if (/^[a-z]+:/.test(target)) return null;
  const [path = '', anchor] = target.split('#');
  const to = path === '' ? file.path : normalize(join(dirname(file.path), path));
  if (!hasPath(to)) return `links to ${target}, which is not there`;
  if (anchor === undefined || !anchors.has(to) || anchors.get(to)!.has(anchor)) return null;
  return `links to ${target}: no such heading`;
}

/** "place: fault" for each target in a file that does not exist. */
export function citationFaults(file: SourceFile, documents: Documents): string[] {
  const faults: string[] = [];
  const say = (index: number, fault: string | null) => {
    if (fault !== null) faults.push(`${placeOf(file, index)} ${fault}`);
  };
  if (file.path.endsWith('.md'))
    for (const { index, 1: target } of file.text.matchAll(LINK))
      say(index, linkFault(file, target!, documents));
  for (const { index, 0: path } of file.text.matchAll(PATH))
    say(index, documents.hasPath(path) ? null : `names ${path}, which is not there`);
  const text = flowing(file.text);
  for (const { index, 1: name, 2: words } of text.matchAll(CITED)) {
    const sections = documents.sections.get(name!);
    if (sections !== undefined && !beginsWithSection(words!, sections))
      say(index, `cites ${name!}, ${words!.replace(/\s+/g, ' ').slice(0, 50)}: no such section`);
  }
  return faults;
}
