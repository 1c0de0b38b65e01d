/**
 * The version of this code's messages, "major.minor". A minor version adds members that an older reader may ignore; a major version changes
 * existing messages.
 */
export const PROTOCOL_VERSION = '1.0';
/** The version assumed for a server that sends none. */
export const FIRST_VERSION = '1.0';

/** Compatibility of a server's version with PROTOCOL_VERSION: `newer` has a higher minor, `foreign` another major or is no version. */
type VersionMatch = 'same' | 'older' | 'newer' | 'foreign';

/** Compares "major.minor" or "major" alone (minor 0) with `own`; absent counts as FIRST_VERSION. Never throws. */
export function matchVersion(version: unknown, own = PROTOCOL_VERSION): VersionMatch {
  const given = version ?? FIRST_VERSION;
  const theirs = VERSION.exec(typeof given === 'string' ? given : '');
  const [major, minor] = own.split('.').map(Number);
  if (theirs === null || Number(theirs[1]) !== major) return 'foreign';
  const ahead = Number(theirs[2] ?? 0) - minor!;
  if (ahead < 0) return 'older';
  return ahead === 0 ? 'same' : 'newer';
}

const VERSION = /^(\d{1,6})(?:\.(\d{1,6}))?$/;
