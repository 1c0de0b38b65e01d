/** What of Trusted Types is used here; not every browser has them. */
interface TrustedTypes {
  readonly createPolicy: (
    name: string,
    rules: { readonly createScriptURL: (url: string) => string },
  ) => { readonly createScriptURL: (url: string) => string };
}

let policy: { readonly createScriptURL: (url: string) => string } | undefined;

/**
 * The address of a program of our own, as a page under `require-trusted-types-for 'script'` takes it for workers.
 * @throws where a policy named `touchdown` is not allowed by the host
 */
export function scriptUrl(url: string): string {
  const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes };
  if (trustedTypes === undefined) return url;
  policy ??= trustedTypes.createPolicy('touchdown', {
    createScriptURL(given) {
      if (new URL(given, location.href).origin !== location.origin)
        throw new TypeError(`${given} is not a program of this page`);
      return given;
    },
  });
  return policy.createScriptURL(url);
}
