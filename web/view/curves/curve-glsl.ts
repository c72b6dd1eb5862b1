// What a vertex makes of the rows of its curves (wasm/include/lissom/curve/pose.h), place and normal.

/** Rows of a curve. */
export const ROWS = 256;
/** Texels of a row of the table: motion (real, dual), three lines of what comes before it, three of both in one. */
export const TEXELS = 8;
export const CURVE_GLSL = /* glsl */ `
uniform sampler2D curveTable; // a curve a line
in uvec4 curveNumbers;
in vec4 curveWeights;
// Of each curve how the row changes with the place, then the row: the first curve's, and three a vertex of the others.
in vec4 curvePlace;
uniform sampler2D curvePlaces;

vec4 ofTable(ivec2 at, int texel) { return texelFetch(curveTable, at + ivec2(texel, 0), 0); }
// Between a row and the next.
vec4 between(ivec2 at, int texel, float share) {
  return mix(ofTable(at, texel), ofTable(at, texel + ${TEXELS}), share);
}
vec3 ofLines(vec4 x, vec4 y, vec4 z, vec4 point) { return vec3(dot(x, point), dot(y, point), dot(z, point)); }
mat3 turnOfLines(vec4 x, vec4 y, vec4 z) { return transpose(mat3(x.xyz, y.xyz, z.xyz)); }

// Sums over the curves of a vertex.
vec4 real, dual;
vec3 sum;
mat3 before, along;
float left;

void add(float weight, uint curve, vec4 place, vec4 here) {
  int first = min(int(place.w), ${ROWS - 2});
  float share = place.w - float(first);
  ivec2 at = ivec2(${TEXELS} * first, curve), next = at + ivec2(${TEXELS}, 0);
  vec3 from = ofLines(ofTable(at, 5), ofTable(at, 6), ofTable(at, 7), here);
  vec3 to = ofLines(ofTable(next, 5), ofTable(next, 6), ofTable(next, 7), here);
  along += weight * outerProduct(to - from, place.xyz);
  vec4 motion = between(at, 0, share);
  float sided = dot(real, motion) < 0.0 ? -weight : weight;
  real += sided * motion;
  dual += sided * between(at, 1, share);
  vec4 x = between(at, 2, share), y = between(at, 3, share), z = between(at, 4, share);
  sum += weight * ofLines(x, y, z, here);
  before += weight * turnOfLines(x, y, z);
  left -= weight;
}

void moved(vec3 place, vec3 normal, out vec3 toPlace, out vec3 toNormal) {
  vec4 here = vec4(place, 1.0);
  bool single = curveWeights.x == 1.0;
  if (single) {
    int first = min(int(curvePlace.w), ${ROWS - 2});
    float share = curvePlace.w - float(first);
    ivec2 at = ivec2(${TEXELS} * first, curveNumbers.x), next = at + ivec2(${TEXELS}, 0);
    vec4 lowX = ofTable(at, 5), lowY = ofTable(at, 6), lowZ = ofTable(at, 7);
    vec4 moreX = ofTable(next, 5) - lowX, moreY = ofTable(next, 6) - lowY, moreZ = ofTable(next, 7) - lowZ;
    vec3 change = ofLines(moreX, moreY, moreZ, here);
    vec4 x = lowX + share * moreX, y = lowY + share * moreY, z = lowZ + share * moreZ;
    toPlace = ofLines(x, y, z, here);
    toNormal = turned(turnOfLines(x, y, z) + outerProduct(change, curvePlace.xyz), normal);
  }
  real = dual = vec4(0.0);
  sum = vec3(0.0);
  before = along = mat3(0.0);
  left = 1.0;
  // A loop, not a branch: drawn in software, all branches are gone through, but loops that no vertex is in are left.
  int count = single ? 0 : 4;
  for (int k = 0; k < count; k++) {
    if (curveWeights[k] == 0.0) continue;
    int other = 3 * gl_VertexID + k - 1, width = textureSize(curvePlaces, 0).x;
    vec4 on = k == 0 ? curvePlace : texelFetch(curvePlaces, ivec2(other % width, other / width), 0);
    add(curveWeights[k], curveNumbers[k], on, here);
  }
  if (single) return;
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
