// Removes indentation, empty lines and comment lines from the shaders in the built page: the GPU's compiler ignores them, and they
// are 2 kB of every download.

/** A template literal that holds GLSL. */
const GLSL = /`[^`]*(?:#include <|gl_|uniform |varying )[^`]*`/g;

/** `text` of a shader without comments and indentation. */
export function compactShader(text) {
  return text
    .replace(/\n\s+/g, '\n')
    .replace(/\n\/\/[^\n]*/g, '')
    .replace(/\n{2,}/g, '\n');
}

/** A plugin of the build. */
export function compactShaders() {
  return {
    name: 'compact-shaders',
    apply: 'build',
    generateBundle(_options, bundle) {
      for (const output of Object.values(bundle))
        if (output.type === 'chunk') output.code = output.code.replace(GLSL, compactShader);
    },
  };
}
