/** The allowed values of a string field with a fixed vocabulary. */
const WORDS: Readonly<Record<string, readonly string[]>> = {
  kind: ['hello', 'frame', 'pong', 'inputs', 'ping'],
  touchdownAttitude: ['aligned', 'kept'],
  surfaceNormal: ['radial', 'terrain'],
  inputGranularity: ['substep', 'tick'],
};
const INTEGERS = ['tick', 'substep', 'seq', 'id'];
const QUATERNIONS = ['attitude', 'targetAttitude'];
const NULLABLE = [
  ...['relativePosition', 'relativeVelocity', 'contactImpactSpeed', 'lastInput', 'substep'],
  ...['wheelMomentum', 'groundContactOffset', 'reactionWheelCapacity', 'dryInertiaRatio'],
];

/** The fault of an accepted record; there must be none for any bytes. */
export function faultsOf(value: unknown, path = ''): string[] {
  const name = path.slice(path.lastIndexOf('.') + 1);
  const fault = (text: string) => [`${path}: ${text}`];
  switch (typeof value) {
    case 'boolean':
      return [];
    case 'number':
      if (!Number.isFinite(value)) return fault(String(value));
      return INTEGERS.includes(name) && !(Number.isSafeInteger(value) && value >= 0)
        ? fault(`not a whole number: ${value}`)
        : [];
    case 'string': {
      const words = WORDS[name];
      if (words !== undefined) return words.includes(value) ? [] : fault(`no word of this field: ${value}`);
      return value.length <= 128 && !/\p{Surrogate}/u.test(value) ? [] : fault('no sane text');
    }
    case 'object':
      if (value === null) return NULLABLE.includes(name) ? [] : fault('null');
      if (QUATERNIONS.includes(name)) {
        const length = Math.hypot(...(value as number[]));
        if (!(Math.abs(length - 1) <= 2e-12)) return fault(`length ${length}`);
      }
      if (![Object.prototype, Array.prototype].includes(Object.getPrototypeOf(value) as object))
        return fault('not plain');
      return Object.entries(value).flatMap(([key, part]) => faultsOf(part, `${path}.${key}`));
    default:
      return fault(typeof value);
  }
}
