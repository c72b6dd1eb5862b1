// A sum of shapes by weights, vertex by vertex.

/** @param origin  the model's own origin, drawn units: weights need not sum to 1 */
export const morphGlsl = (shapes: number, origin: readonly [number, number, number]): string => /* glsl */ `
uniform sampler2D morphShapes; // place, then normal, of each shape, vertex by vertex
uniform sampler2D morphWeights;
const int SHAPES = ${shapes};
const vec3 ORIGIN = vec3(${origin.map((x) => x.toExponential()).join(', ')});

void moved(vec3 place, vec3 normal, out vec3 toPlace, out vec3 toNormal) {
  int width = textureSize(morphShapes, 0).x;
  vec3 sum = vec3(0.0), facing = vec3(0.0);
  for (int shape = 0; shape < SHAPES; shape++) {
    // A correction counts as it is; shapes count from the model's origin.
    vec2 weight = texelFetch(morphWeights, ivec2(shape, 0), 0).xy;
    if (weight.x == 0.0) continue;
    int at = 2 * (gl_VertexID * SHAPES + shape);
    vec3 shown = texelFetch(morphShapes, ivec2(at % width, at / width), 0).xyz;
    sum += weight.x * (shown - weight.y * ORIGIN);
    facing += weight.x * texelFetch(morphShapes, ivec2((at + 1) % width, (at + 1) / width), 0).xyz;
  }
  toPlace = sum + ORIGIN;
  float size = length(facing);
  toNormal = size > 1e-6 ? facing / size : normal;
}
`;
