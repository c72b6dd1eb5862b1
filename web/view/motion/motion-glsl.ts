// The pass around a motion: what is moved, and how far it has come to where it goes.

/** Writes drawn places and normals of the moved surface; draws nothing. @param motion  defines `moved` */
export const motionVertex = (motion: string): string => /* glsl */ `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp sampler2D;
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 facing;
// Where the surface is on its way to, and how far it has come.
layout(location = 2) in vec3 wantedPlace;
layout(location = 3) in vec3 wantedFacing;
uniform float motionArrival;
out vec3 movedPlace;
out vec3 movedNormal;

// A normal goes by the cofactors, which need no division where the surface is folded flat.
vec3 turned(mat3 derivative, vec3 normal) {
  vec3 across =
    mat3(cross(derivative[1], derivative[2]), cross(derivative[2], derivative[0]), cross(derivative[0], derivative[1])) * normal;
  float size = length(across);
  return size > 0.0 ? across / size : normal;
}
${motion}
void main() {
  moved(place, facing, movedPlace, movedNormal);
  if (motionArrival > 0.0) {
    movedPlace = mix(movedPlace, wantedPlace, motionArrival);
    movedNormal = normalize(mix(movedNormal, wantedFacing, motionArrival) + 1e-9 * movedNormal);
  }
}
`;

/** A program has one. */
export const MOTION_FRAGMENT = /* glsl */ `#version 300 es
precision lowp float;
void main() {}
`;
