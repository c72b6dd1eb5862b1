// The controls' transformations blended, for each vertex by the values of its fields.

import type { IsolineSurface } from './types';

/** @param steepest  the longest part of a gradient, 1 per drawn unit */
export const isolineGlsl = (
  { sets, single, basis, controls }: Pick<IsolineSurface, 'sets' | 'single' | 'basis' | 'controls'>,
  steepest: number,
): string => /* glsl */ `
uniform usampler2D isolineFields; // the gradient about 32767, then the value, in 65535ths
uniform sampler2D isolineOffsets; // three rows a control
const int SETS = ${sets};
const int CONTROLS = ${controls}; // of a set
const bool SINGLE = ${single};
const bool QUADRATIC = ${basis === 'quadratic'};
const float STEEPEST = ${steepest.toExponential()};

// Values and slopes of the two or three functions that are not 0 at phi; the first one's number is returned.
int isolineBasis(float phi, out vec3 value, out vec3 slope) {
  if (!QUADRATIC) {
    float spans = float(CONTROLS - 1);
    int span = min(int(phi * spans), CONTROLS - 2);
    float t = phi * spans - float(span);
    value = vec3(1.0 - t, t, 0.0);
    slope = vec3(-spans, spans, 0.0);
    return span;
  }
  // Clamped uniform knots, by Cox and de Boor.
  float spans = float(CONTROLS - 2);
  int span = min(int(phi * spans), CONTROLS - 3);
  float s = float(span);
  float u = phi * spans;
  float left1 = u - s, right1 = s + 1.0 - u;
  float left2 = u - max(s - 1.0, 0.0), right2 = min(s + 2.0, spans) - u;
  float below = right1 + left2, above = right2 + left1;
  value = vec3(right1 * right1 / below, left2 * right1 / below + right2 * left1 / above, left1 * left1 / above);
  slope = 2.0 * spans * vec3(-right1 / below, right1 / below - left1 / above, left1 / above);
  return span;
}

void moved(vec3 place, vec3 normal, out vec3 toPlace, out vec3 toNormal) {
  toPlace = place;
  toNormal = normal;
  vec3 by = vec3(0.0);
  mat3 turn = mat3(1.0); // the derivative of the moved place
  int width = textureSize(isolineFields, 0).x;
  for (int set = 0; set < SETS; set++) {
    int at = gl_VertexID * SETS + set;
    uvec4 texel = texelFetch(isolineFields, ivec2(at % width, at / width), 0);
    if (texel.x == 65535u) return;
    if (texel.w == 0u && !SINGLE) continue;
    float phi = float(texel.w) / 65535.0;
    vec3 value, slope;
    int first = set * CONTROLS + isolineBasis(phi, value, slope);
    // Rows of the offset and of its change with the field.
    vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0), dx = vec4(0.0), dy = vec4(0.0), dz = vec4(0.0);
    for (int q = 0; q < 3; q++) {
      if (value[q] == 0.0 && slope[q] == 0.0) continue;
      vec4 rowX = texelFetch(isolineOffsets, ivec2(0, first + q), 0);
      vec4 rowY = texelFetch(isolineOffsets, ivec2(1, first + q), 0);
      vec4 rowZ = texelFetch(isolineOffsets, ivec2(2, first + q), 0);
      x += value[q] * rowX; y += value[q] * rowY; z += value[q] * rowZ;
      dx += slope[q] * rowX; dy += slope[q] * rowY; dz += slope[q] * rowZ;
    }
    float share = SINGLE ? 1.0 : phi;
    vec4 here = vec4(place, 1.0);
    vec3 shift = vec3(dot(x, here), dot(y, here), dot(z, here));
    vec3 change = vec3(dot(dx, here), dot(dy, here), dot(dz, here)) * share;
    if (!SINGLE) change += shift;
    by += share * shift;
    turn += share * transpose(mat3(x.xyz, y.xyz, z.xyz));
    vec3 gradient = (vec3(texel.xyz) - 32767.0) * (STEEPEST / 32767.0);
    turn += outerProduct(change, gradient);
  }
  toPlace = place + by;
  toNormal = turned(turn, normal);
}
`;
