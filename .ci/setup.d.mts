/** An entry of package-lock.json's `packages`. */
export interface LockEntry {
  readonly version?: string;
  readonly dev?: boolean;
  readonly devOptional?: boolean;
  readonly optional?: boolean;
  readonly os?: readonly string[];
  readonly cpu?: readonly string[];
  readonly libc?: readonly string[];
}
export interface Machine {
  readonly os: string;
  readonly cpu: string;
  readonly libc?: string;
}
export function nodeComplaint(version: string): string | null;
export function missingPackages(
  packages: Readonly<Record<string, LockEntry>>,
  purpose: 'start' | 'test',
  machine: Machine,
  versionAt: (path: string) => string | undefined,
): string[];
export function causeOf(npmErrors: string): string;
