import { ROW_BITS } from './quantise';

/** Strands as their texture holds them. */
export const STRAND_POINTS = /* glsl */ `
precision highp usampler2D;
uniform usampler2D strandPoints;
uniform vec3 boxLow;
uniform vec3 boxSize;
uniform int perStrand;

// O'Neill, "PCG: a family of simple fast algorithms" (2014), the RXS-M-XS output function.
uint scramble(uint x) {
  x = x * 747796405u + 2891336453u;
  x = ((x >> ((x >> 28u) + 4u)) ^ x) * 277803737u;
  return (x >> 22u) ^ x;
}
float unit(uint x) { return float(scramble(x) >> 8u) / 16777216.0; }

int numberOf(int strand, int point) { return strand * perStrand + clamp(point, 0, perStrand - 1); }
ivec2 cellOf(int number) { return ivec2(number & ${(1 << ROW_BITS) - 1}, number >> ${ROW_BITS}); }
uvec4 texelOf(int strand, int point) { return texelFetch(strandPoints, cellOf(numberOf(strand, point)), 0); }
vec3 placeOf(uvec4 texel) { return boxLow + boxSize * (vec3(texel.xyz) / 65535.0); }
// From the point before to the point after; zero where a strand has no length.
vec3 alongOf(int strand, int point) {
  return placeOf(texelOf(strand, point + 1)) - placeOf(texelOf(strand, point - 1));
}
`;

/** A strand's ribbon: two vertices per point, turned towards the eye, never thinner than a pixel. */
export const RIBBON = /* glsl */ `
${STRAND_POINTS}
uniform float rootWidth;  // drawn units
uniform float taper;      // tip's width as a share of the root's
uniform float pixels;     // height of the picture

struct Ribbon {
  vec3 place;
  float cover;  // true width over drawn width
};

// corner.x: side −1 or 1; corner.y: point
Ribbon ribbonAt(vec2 corner, int strand, mat4 view, mat4 projection) {
  int i = int(corner.y);
  vec3 place = placeOf(texelOf(strand, i));
  vec3 along = alongOf(strand, i);
  bool flat_ = projection[3][3] == 1.0;
  vec3 back = vec3(view[0][2], view[1][2], view[2][2]);
  vec3 eye = -(transpose(mat3(view)) * view[3].xyz);
  vec3 across = cross(along, flat_ ? back : eye - place);
  float size = length(across);
  across = size > 1e-9 ? across / size : vec3(view[0][0], view[1][0], view[2][0]);
  float width = rootWidth * mix(1.0, taper, corner.y / float(perStrand - 1));
  float depth = -(view * vec4(place, 1.0)).z;
  float pixel = 2.0 * (flat_ ? 1.0 : max(depth, 1e-4)) / (projection[1][1] * pixels);
  // A strand without length has no direction: it is not drawn.
  float drawn = dot(along, along) == 0.0 ? 0.0 : max(width, pixel);
  return Ribbon(place + 0.5 * drawn * corner.x * across, min(1.0, width / pixel));
}
`;

/** The light that strands take away before it arrives at a place: deep opacity maps, Yuksel & Keyser 2008. */
export const OPACITY_LOOKUP = /* glsl */ `
uniform sampler2D opacityFront;   // depth of the first hair
uniform sampler2D opacityLayers;  // covered depth within 1, 3, 7 steps behind it, and in all
uniform sampler2D headFront;
uniform mat4 lightMatrix;         // drawn place to the maps' [0, 1]³
uniform float layerStep;          // in depths of the map

float depthIn(vec4 layers, float x) {
  if (x <= 0.0) return 0.0;
  if (x < 1.0) return layers.r * x;
  if (x < 3.0) return mix(layers.r, layers.g, (x - 1.0) / 2.0);
  if (x < 7.0) return mix(layers.g, layers.b, (x - 3.0) / 4.0);
  return mix(layers.b, layers.a, min(1.0, (x - 7.0) / 8.0));
}

// x: strands crossed on the way from the light; y: the head's shadow, 1 in the light
vec2 keyLightAt(vec3 place, float strandBias, float headBias) {
  vec3 at = (lightMatrix * vec4(place, 1.0)).xyz;
  ivec2 size = textureSize(opacityLayers, 0);
  vec2 texel = at.xy * vec2(size) - 0.5;
  ivec2 corner = ivec2(floor(texel));
  vec2 f = texel - vec2(corner);
  vec2 sum = vec2(0.0);
  for (int k = 0; k < 4; k++) {
    ivec2 step_ = ivec2(k & 1, k >> 1);
    ivec2 p = corner + step_;
    float weight = (step_.x == 1 ? f.x : 1.0 - f.x) * (step_.y == 1 ? f.y : 1.0 - f.y);
    if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, size))) {
      sum.y += weight;
      continue;
    }
    float x = (at.z - texelFetch(opacityFront, p, 0).r) / layerStep - strandBias;
    sum.x += weight * depthIn(texelFetch(opacityLayers, p, 0), x);
    sum.y += weight * step(at.z, texelFetch(headFront, p, 0).r + headBias * layerStep);
  }
  return sum;
}
`;
