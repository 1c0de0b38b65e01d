/** Writes the script into the folder `outDir` and returns its path. */
export function bundleScript(outDir: string): Promise<string>;
