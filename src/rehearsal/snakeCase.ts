/** The names of ours in a text as the game writes them in JSON: contactCrashSpeed → contact_crash_speed; other words stay. */
export function snakeCase(text: string): string {
  return text.replace(/\b[a-z]+(?:[A-Z][a-z]*)+\b/g, (name) =>
    name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`),
  );
}
