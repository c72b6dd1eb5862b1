// What a vertex makes of the rows of its curves (wasm/include/lissom/curve/pose.h), place and normal.

/** Rows of a curve. */
export const ROWS = 256;
/** Texels of a row of the table: motion (real, dual), three lines of what comes before it, three of both in one. */
export const TEXELS = 8;
/** Of a row at rest: place, direction in rows per length, curvature. */
export const SLOPES = 3;

export const CURVE_GLSL = /* glsl */ `
uniform sampler2D curveTable;  // a curve a line
uniform sampler2D curveSlopes;
in uvec4 curveNumbers;
in vec4 curveRows;
in vec4 curveWeights;

vec3 ofLines(vec4 x, vec4 y, vec4 z, vec4 point) { return vec3(dot(x, point), dot(y, point), dot(z, point)); }
mat3 turnOfLines(vec4 x, vec4 y, vec4 z) { return transpose(mat3(x.xyz, y.xyz, z.xyz)); }

vec4 ofTable(ivec2 at, int texel) { return texelFetch(curveTable, at + ivec2(texel, 0), 0); }
// Between a row and the next.
vec4 between(ivec2 at, int texel, float share) {
  return mix(ofTable(at, texel), ofTable(at, texel + ${TEXELS}), share);
}
vec3 slopeBetween(ivec2 at, int texel, float share) {
  return mix(
    texelFetch(curveSlopes, at + ivec2(texel, 0), 0).xyz,
    texelFetch(curveSlopes, at + ivec2(texel + ${SLOPES}, 0), 0).xyz,
    share);
}

// How the row changes with the place; nothing does beyond the ends.
vec3 rowGradient(float row, int first, float share, int curve, vec3 place) {
  if (row <= 0.0 || row >= ${ROWS - 1}.0) return vec3(0.0);
  ivec2 at = ivec2(${SLOPES} * first, curve);
  vec3 from = place - slopeBetween(at, 0, share);
  return slopeBetween(at, 1, share) / max(1.0 - dot(slopeBetween(at, 2, share), from), 0.05);
}

void moved(vec3 place, vec3 normal, out vec3 toPlace, out vec3 toNormal) {
  vec4 here = vec4(place, 1.0);
  vec4 real = vec4(0.0), dual = vec4(0.0);
  vec3 sum = vec3(0.0);
  mat3 before = mat3(0.0), along = mat3(0.0);
  float left = 1.0;
  for (int k = 0; k < 4; k++) {
    float weight = curveWeights[k];
    if (weight == 0.0) continue;
    float row = curveRows[k];
    int curve = int(curveNumbers[k]);
    int first = min(int(row), ${ROWS - 2});
    float share = row - float(first);
    ivec2 at = ivec2(${TEXELS} * first, curve), next = at + ivec2(${TEXELS}, 0);
    vec4 lowX = ofTable(at, 5), lowY = ofTable(at, 6), lowZ = ofTable(at, 7);
    vec4 highX = ofTable(next, 5), highY = ofTable(next, 6), highZ = ofTable(next, 7);
    vec3 from = ofLines(lowX, lowY, lowZ, here), to = ofLines(highX, highY, highZ, here);
    mat3 change = outerProduct(to - from, rowGradient(row, first, share, curve, place));
    if (weight == 1.0) {
      toPlace = mix(from, to, share);
      mat3 turn = turnOfLines(mix(lowX, highX, share), mix(lowY, highY, share), mix(lowZ, highZ, share));
      toNormal = turned(turn + change, normal);
      return;
    }
    vec4 motion = between(at, 0, share);
    float sided = dot(real, motion) < 0.0 ? -weight : weight;
    real += sided * motion;
    dual += sided * between(at, 1, share);
    vec4 x = between(at, 2, share), y = between(at, 3, share), z = between(at, 4, share);
    sum += weight * ofLines(x, y, z, here);
    before += weight * turnOfLines(x, y, z);
    along += weight * change;
    left -= weight;
  }
  // What the weights leave rests.
  real.w += real.w < 0.0 ? -left : left;
  sum += left * place;
  before += mat3(left);
  float size = 1.0 / length(real);
  real *= size;
  dual *= size;
  vec3 r = real.xyz;
  toPlace = sum + 2.0 * (cross(r, cross(r, sum) + real.w * sum + dual.xyz) + real.w * dual.xyz - dual.w * r);
  for (int c = 0; c < 3; c++) before[c] += 2.0 * cross(r, cross(r, before[c]) + real.w * before[c]);
  toNormal = turned(before + along, normal);
}
`;
