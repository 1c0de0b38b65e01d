/** A body in a sentence: the game calls the Moon Luna. */
export function placeName(body: string): string {
  return body === 'Luna' ? 'the Moon' : body;
}
