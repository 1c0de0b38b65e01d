/**
 * The version of these messages that this code speaks, "major.minor". A minor step adds what an older reader may skip; a
 * major step changes what is there.
 */
export const PROTOCOL_VERSION = '1.0';
/** What a server speaks that tells no version. */
export const FIRST_VERSION = '1.0';

/** How a server's version stands to PROTOCOL_VERSION: `newer` has a higher minor, `foreign` another major or is no version. */
type VersionMatch = 'same' | 'older' | 'newer' | 'foreign';

/** Compares "major.minor" or "major" alone (minor 0) with PROTOCOL_VERSION; not told is FIRST_VERSION. Never throws, whatever is given. */
export function matchVersion(version: unknown): VersionMatch {
  const given = version ?? FIRST_VERSION;
  const told = VERSION.exec(typeof given === 'string' ? given : '');
  const own = VERSION.exec(PROTOCOL_VERSION)!;
  if (told === null || Number(told[1]) !== Number(own[1])) return 'foreign';
  const ahead = Number(told[2] ?? 0) - Number(own[2] ?? 0);
  if (ahead === 0) return 'same';
  return ahead > 0 ? 'newer' : 'older';
}

const VERSION = /^(\d{1,6})(?:\.(\d{1,6}))?$/;
