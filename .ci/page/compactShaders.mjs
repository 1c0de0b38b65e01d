// Removes comments, indentation, empty lines and the spaces between tokens from the shaders in the built page: the GPU's compiler
// ignores them, and they are 6 kB of every download.

/** A template literal that three and the scene mark as GLSL. */
const GLSL = /(\/\* glsl \*\/\s*)(`[^`]*`)/g;

/** A line without spaces between tokens. `a - -b` keeps the second space, and a directive all: `#define A (b)` is not `#define A(b)`. */
const compactLine = (line) =>
  line.startsWith('#') || line.includes('${')
    ? line
    : line.replace(/ *([*/=<>(){},;?:&|!]) */g, '$1').replace(/(?<![-+]) *([-+]) *(?![-+ ])/g, '$1');

/** `text` of a shader without comments, indentation and spaces. */
export function compactShader(text) {
  return text
    .replace(/\/\*[\s\S]*?\*\//g, '')
    .replace(/[ \t]*\/\/[^\n]*/g, '')
    .replace(/[ \t]*\n\s*/g, '\n')
    .split('\n')
    .map(compactLine)
    .join('\n');
}

/** A plugin of the build. */
export const compactShaders = () => ({
  name: 'compact-shaders',
  apply: 'build',
  enforce: 'pre',
  transform: (code) => code.replace(GLSL, (_all, mark, shader) => mark + compactShader(shader)),
});
