// The blend of the controls' transformations, for each vertex by the values of its fields.

/** Writes drawn places and normals of the moved surface; draws nothing. */
export const BLEND_VERTEX = /* glsl */ `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp sampler2D;
uniform usampler2D blendFields; // the gradient about 32767, then the value, in 65535ths
uniform sampler2D blendOffsets; // three rows a control
uniform int blendSets;
uniform int blendControls;      // of a set
uniform bool blendSingle;
uniform bool blendQuadratic;
uniform float blendSteepest;
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 facing;
// Where the surface is on its way to, and how far it has come.
layout(location = 2) in vec3 wantedPlace;
layout(location = 3) in vec3 wantedFacing;
uniform float blendArrival;
out vec3 movedPlace;
out vec3 movedNormal;

// Values and slopes of the two or three functions that are not 0 at phi; the first one's number is returned.
int blendBasis(float phi, out vec3 value, out vec3 slope) {
  if (!blendQuadratic) {
    float spans = float(blendControls - 1);
    int span = min(int(phi * spans), blendControls - 2);
    float t = phi * spans - float(span);
    value = vec3(1.0 - t, t, 0.0);
    slope = vec3(-spans, spans, 0.0);
    return span;
  }
  // Clamped uniform knots, by Cox and de Boor.
  float spans = float(blendControls - 2);
  int span = min(int(phi * spans), blendControls - 3);
  float s = float(span);
  float u = phi * spans;
  float left1 = u - s, right1 = s + 1.0 - u;
  float left2 = u - max(s - 1.0, 0.0), right2 = min(s + 2.0, spans) - u;
  float below = right1 + left2, above = right2 + left1;
  value = vec3(right1 * right1 / below, left2 * right1 / below + right2 * left1 / above, left1 * left1 / above);
  slope = 2.0 * spans * vec3(-right1 / below, right1 / below - left1 / above, left1 / above);
  return span;
}

void main() {
  movedPlace = place;
  movedNormal = facing;
  vec3 by = vec3(0.0);
  mat3 turn = mat3(1.0); // the derivative of the moved place
  int width = textureSize(blendFields, 0).x;
  for (int set = 0; set < blendSets; set++) {
    int at = gl_VertexID * blendSets + set;
    uvec4 texel = texelFetch(blendFields, ivec2(at % width, at / width), 0);
    if (texel.x == 65535u) return;
    if (texel.w == 0u && !blendSingle) continue;
    float phi = float(texel.w) / 65535.0;
    vec3 value, slope;
    int first = set * blendControls + blendBasis(phi, value, slope);
    // Rows of the offset and of its change with the field.
    vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0), dx = vec4(0.0), dy = vec4(0.0), dz = vec4(0.0);
    for (int q = 0; q < 3; q++) {
      if (value[q] == 0.0 && slope[q] == 0.0) continue;
      vec4 rowX = texelFetch(blendOffsets, ivec2(0, first + q), 0);
      vec4 rowY = texelFetch(blendOffsets, ivec2(1, first + q), 0);
      vec4 rowZ = texelFetch(blendOffsets, ivec2(2, first + q), 0);
      x += value[q] * rowX; y += value[q] * rowY; z += value[q] * rowZ;
      dx += slope[q] * rowX; dy += slope[q] * rowY; dz += slope[q] * rowZ;
    }
    float share = blendSingle ? 1.0 : phi;
    vec4 here = vec4(place, 1.0);
    vec3 moved = vec3(dot(x, here), dot(y, here), dot(z, here));
    vec3 change = vec3(dot(dx, here), dot(dy, here), dot(dz, here)) * share;
    if (!blendSingle) change += moved;
    by += share * moved;
    turn += share * transpose(mat3(x.xyz, y.xyz, z.xyz));
    vec3 gradient = (vec3(texel.xyz) - 32767.0) * (blendSteepest / 32767.0);
    turn += outerProduct(change, gradient);
  }
  movedPlace = place + by;
  // A normal goes by the cofactors, which need no division where the surface is folded flat.
  vec3 across = mat3(cross(turn[1], turn[2]), cross(turn[2], turn[0]), cross(turn[0], turn[1])) * facing;
  float size = length(across);
  if (size > 0.0) movedNormal = across / size;
  if (blendArrival > 0.0) {
    movedPlace = mix(movedPlace, wantedPlace, blendArrival);
    movedNormal = normalize(mix(movedNormal, wantedFacing, blendArrival) + 1e-9 * movedNormal);
  }
}
`;

/** A program has one. */
export const BLEND_FRAGMENT = /* glsl */ `#version 300 es
precision lowp float;
void main() {}
`;
