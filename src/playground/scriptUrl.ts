/** The members of Trusted Types that are used; not every browser has them. */
interface TrustedTypes {
  readonly createPolicy: (
    name: string,
    rules: { readonly createScriptURL: (url: string) => string },
  ) => { readonly createScriptURL: (url: string) => string };
}

let policy: { readonly createScriptURL: (url: string) => string } | undefined;

/**
 * The address of one of our programs, in the form that a page under `require-trusted-types-for 'script'` accepts for workers.
 * @throws if the host does not allow a policy named `touchdown`
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
