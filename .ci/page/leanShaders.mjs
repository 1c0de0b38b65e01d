// Leaves out of three's shaders the branches that no material of the page takes: 6 kB of every download.

/** Never defined, or 0, in the page's materials and lights. */
const UNUSED = [
  'NUM_CLIPPING_PLANES',
  'NUM_LIGHT_PROBE_GRIDS',
  'NUM_RECT_AREA_LIGHTS',
  'NUM_SPOT_LIGHTS',
  'NUM_SPOT_LIGHT_COORDS',
  'NUM_SPOT_LIGHT_MAPS',
  'NUM_SPOT_LIGHT_SHADOWS',
  'NUM_SUN_LIGHTS',
  'NUM_SUN_LIGHT_SHADOWS',
  'PHYSICAL',
  'USE_ALPHAHASH',
  'USE_ALPHAMAP',
  'USE_ANISOTROPY',
  'USE_AOMAP',
  'USE_BATCHING',
  'USE_BATCHING_COLOR',
  'USE_BUMPMAP',
  'USE_CLEARCOAT',
  'USE_DIFFUSE_ROUGHNESS',
  'USE_DISPERSION',
  'USE_DISPLACEMENTMAP',
  'USE_EMISSIVEMAP',
  'USE_ENVMAP',
  'USE_FOG',
  'USE_GRADIENTMAP',
  'USE_INSTANCING_MORPH',
  'USE_IRIDESCENCE',
  'USE_LIGHTMAP',
  'USE_LIGHT_PROBES',
  'USE_LOGARITHMIC_DEPTH_BUFFER',
  'USE_METALNESSMAP',
  'USE_MORPHCOLORS',
  'USE_MORPHNORMALS',
  'USE_MORPHTARGETS',
  'USE_NORMALMAP',
  'USE_RETROREFLECTION',
  'USE_ROUGHNESSMAP',
  'USE_SHEEN',
  'USE_SKINNING',
  'USE_SPECULARMAP',
  'USE_SPECULAR_COLORMAP',
  'USE_SPECULAR_INTENSITYMAP',
  'USE_TANGENT',
  'USE_TRANSMISSION',
];
/** Defined with one of those alone: USE_CLEARCOATMAP, USE_NORMALMAP_TANGENTSPACE. */
const isUnused = (name) =>
  UNUSED.some((unused) => name === unused || (/^USE_/.test(name) && name.startsWith(`${unused}MAP`)));

/** Whether a condition never holds; one that is not as simple as these counts as possible. */
function isNever(condition) {
  const text = condition.replace(/\/\/.*/, '').trim();
  return text.split('||').every((part) => {
    const [, defined, counted] =
      /^\(?\s*(?:defined\s*\(\s*(\w+)\s*\)|(\w+) > 0)\s*\)?(?:\s*&&.*)?$/.exec(part.trim()) ?? [];
    return isUnused(defined ?? counted ?? '');
  });
}

/** `text` of a shader without the branches that are never taken. */
export function leanShader(text) {
  /** Of each open condition: 'kept' as it is, 'gone' up to its #else, or 'bare': without its own lines. */
  const open = [];
  const out = [];
  const isHidden = () => open.includes('gone');
  for (const line of text.split('\n')) {
    const [, directive, condition] = /^\s*#\s*(ifdef|ifndef|if|elif|else|endif)\b(.*)/.exec(line) ?? [];
    if (directive === undefined) {
      if (!isHidden()) out.push(line);
    } else if (directive === 'endif') {
      const state = open.pop();
      if (state === undefined) throw new Error('leanShader: an #endif too many');
      if (state === 'kept' && !isHidden()) out.push(line);
    } else if (directive === 'else' || directive === 'elif') {
      const state = open.pop();
      if (state === 'kept') {
        open.push(state);
        if (!isHidden()) out.push(line);
      } else if (directive === 'else') open.push(state === 'gone' ? 'bare' : 'gone');
      else if (state === 'gone') {
        if (!isHidden()) out.push(`#if${condition}`);
        open.push('kept');
      } else throw new Error('leanShader: an #elif of an #ifndef');
    } else {
      const never =
        directive === 'if' ? isNever(condition) : isUnused(condition.replace(/\/\/.*/, '').trim());
      if (!never && !isHidden()) out.push(line);
      open.push(!never ? 'kept' : directive === 'ifndef' ? 'bare' : 'gone');
    }
  }
  if (open.length > 0) throw new Error('leanShader: a condition without an end');
  return out.join('\n');
}
