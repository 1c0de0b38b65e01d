/** Sends an event with the members to a target; whether the page took it from the browser. */
export function send(to: EventTarget, type: string, members: object = {}): boolean {
  const event = new Event(type, { cancelable: true });
  for (const [name, value] of Object.entries(members)) Object.defineProperty(event, name, { value });
  to.dispatchEvent(event);
  return event.defaultPrevented;
}
