// What light does in hair. Angles as Marschner et al., "Light scattering from human hair fibers" (2003):
// θ from the plane across the strand, φ around it; the tangent points from root to tip.

import { OPACITY_LOOKUP, RIBBON } from './strand-glsl';

export const SHADE_VERTEX = /* glsl */ `
${RIBBON}
uniform vec3 hairColour;       // linear
uniform float colourVariation; // 0..1
uniform bool natural;
varying vec3 vPlace;
varying vec3 vTangent;
varying vec3 vColour;
varying float vAlong;
varying float vSide;
varying float vCover;
flat varying vec2 vChance;

void main() {
  Ribbon r = ribbonAt(position.xy, gl_InstanceID, viewMatrix, projectionMatrix);
  vPlace = r.place;
  vTangent = r.tangent;
  vAlong = r.along;
  vSide = position.x;
  vCover = r.cover;
  vChance = vec2(unit(r.seed * 2u + 0x9e3779b9u * frame), unit(r.seed ^ 0x5bd1e995u));
  float lighter = unit(r.seed + 0x68bc21ebu) - 0.5;
  float warmer = unit(r.seed + 0x02e5be93u) - 0.5;
  float ofGroup = r.group == 0u ? 0.0 : unit(r.group + 0x7f4a7c15u) - 0.5;
  float amount = 1.6 * colourVariation;
  vec3 colour = hairColour * exp(amount * (lighter + 0.7 * ofGroup));
  colour *= exp(amount * 0.5 * warmer * vec3(0.5, 0.0, -0.7));
  // Sun and wear bleach towards the tips.
  if (natural) colour *= mix(0.78, 1.22, smoothstep(0.0, 1.0, r.along));
  vColour = min(colour, vec3(0.94));
  gl_Position = projectionMatrix * viewMatrix * vec4(r.place, 1.0);
}`;

export const SHADE_FRAGMENT = /* glsl */ `
precision highp sampler3D;
${OPACITY_LOOKUP}
uniform bool natural;
uniform bool multisampled;
uniform vec3 keyDirection;
uniform vec3 keyLight;
uniform vec3 softDirection[3];
uniform vec3 softLight[3];
uniform float softSpread[3];   // half the lamp's angle
uniform vec3 skyLight;
uniform vec3 groundLight;
uniform sampler3D lightGrid;   // openness; what is left of the three soft lights after a quarter of the way
uniform vec3 gridLow;
uniform float gridSize;
varying vec3 vPlace;
varying vec3 vTangent;
varying vec3 vColour;
varying float vAlong;
varying float vSide;
varying float vCover;
flat varying vec2 vChance;

const float PI = 3.14159265;

float bell(float x, float width) { return exp(-0.5 * x * x / (width * width)) / (2.5066283 * width); }

struct Fibre {
  vec3 tangent;
  vec3 eye;
  float sinEye;
  vec3 through;  // what one crossing of a strand leaves of white
  float tilt;    // of the scales
};

// Light of one lamp that strands send to the eye. near: the share that comes straight; far: per colour,
// what arrives through other strands as well.
vec3 lit(Fibre fibre, vec3 towards, float spread, vec3 colour, float near, vec3 far) {
  float sinLight = clamp(dot(fibre.tangent, towards), -1.0, 1.0);
  float cosLight = sqrt(1.0 - sinLight * sinLight);
  float thetaLight = asin(sinLight);
  float thetaEye = asin(clamp(fibre.sinEye, -1.0, 1.0));
  float half_ = 0.5 * (thetaLight + thetaEye);
  float cosDiff = cos(0.5 * (thetaEye - thetaLight));
  vec3 a = towards - sinLight * fibre.tangent;
  vec3 b = fibre.eye - fibre.sinEye * fibre.tangent;
  float cosPhi = clamp(dot(a, b) * inversesqrt(max(dot(a, a) * dot(b, b), 1e-8)), -1.0, 1.0);
  float cosHalfPhi = sqrt(max(0.0, 0.5 + 0.5 * cosPhi));
  float fresnel = 0.046 + 0.954 * pow(1.0 - cosDiff * cosHalfPhi, 5.0);
  // Roughness of the lobes 1 : ½ : 2, shifts −2 : 1 : 3 (Marschner 2003, table 1), widened by the lamp.
  float soft = 0.12 + 0.4 * spread;
  vec3 r = vec3(bell(half_ + fibre.tilt, soft) * 0.25 * cosHalfPhi * fresnel);
  // Around the strand: fits of the thick-cylinder integrals by Karis, "Physically based hair shading" (2016).
  vec3 tt = bell(half_ - 0.5 * fibre.tilt, 0.6 * soft) * exp(-3.65 * cosPhi - 3.98) * fibre.through;
  vec3 trt = bell(half_ - 1.5 * fibre.tilt, 1.7 * soft) * exp(17.0 * cosPhi - 16.78) * 0.12 * fibre.through * fibre.through;
  float cosines = cosLight / max(0.25, cosDiff * cosDiff);
  vec3 single = (r + trt) * near + tt * far * mix(0.35, 1.0, near);
  // What has bounced between strands has lost its direction but for a preference for the lit side.
  float wrap = (0.45 + 0.55 * dot(normalize(b), towards)) * cosLight;
  vec3 many = colour * max(0.0, 0.25 + 0.75 * wrap) / PI;
  return single * cosines + many * far * mix(0.7, 1.0, near);
}

// Kajiya & Kay, "Rendering fur with three dimensional textures" (1989), equations 14 to 16.
vec3 kajiyaKay(vec3 tangent, vec3 eye, vec3 towards, vec3 colour) {
  float cosLight = dot(tangent, towards);
  float cosEye = dot(tangent, eye);
  float sinLight = sqrt(max(0.0, 1.0 - cosLight * cosLight));
  float sinEye = sqrt(max(0.0, 1.0 - cosEye * cosEye));
  float shine = pow(max(0.0, sinLight * sinEye - cosLight * cosEye), 40.0);
  return colour * sinLight / PI + vec3(0.1 * shine);
}

void main() {
  float width = 2.0 * (vCover - vChance.x) + 0.5;
  float alpha = clamp(vCover >= 1.0 ? 1.0 : width, 0.0, 1.0);
  if (multisampled ? alpha <= 0.0 : alpha < 0.5) discard;
  vec3 tangent = normalize(vTangent);
  vec3 eye = isOrthographic ? vec3(viewMatrix[0][2], viewMatrix[1][2], viewMatrix[2][2]) : normalize(cameraPosition - vPlace);
  vec4 light = texture(lightGrid, clamp((vPlace - gridLow) / gridSize, 0.0, 1.0));
  vec3 softDepth = -4.0 * log(max(light.gba, 1.0 / 512.0));
  vec2 key = keyLightAt(vPlace, 0.3, 3.0);

  vec3 colour = vColour;
  // Strands absorb per crossing what, over the many crossings in a head of hair, makes this colour:
  // Chiang et al., "A practical and controllable hair and fur model" (2016), equation 9 at roughness 0.3.
  vec3 sigma = pow(log(max(colour, vec3(0.002))) / 5.89, vec3(2.0));
  Fibre fibre = Fibre(tangent, eye, dot(tangent, eye), exp(-2.0 * sigma), 0.1 + 0.1 * (vChance.y - 0.5));
  // Loss per crossed strand of light that goes on forwards.
  vec3 loss = 0.1 + 0.55 * (1.0 - exp(-1.6 * sigma));

  vec3 sum;
  if (natural) {
    sum = keyLight * key.y * lit(fibre, keyDirection, 0.05, colour, exp(-0.9 * key.x), exp(-loss * key.x));
    for (int i = 0; i < 3; i++) {
      float depth = softDepth[i];
      sum += softLight[i] * lit(fibre, softDirection[i], softSpread[i], colour, exp(-0.9 * depth), exp(-loss * depth));
    }
    vec3 facing = normalize(eye - fibre.sinEye * tangent);
    vec3 around = mix(groundLight, skyLight, 0.5 + 0.4 * facing.y + 0.1 * eye.y);
    // Openness squared: light that came in has to come out again.
    sum += around * colour * light.r * mix(0.5, 1.0, light.r);
  } else {
    sum = keyLight * key.y * exp(-0.9 * key.x) * kajiyaKay(tangent, eye, keyDirection, colour);
    for (int i = 0; i < 3; i++) sum += softLight[i] * exp(-softDepth[i]) * kajiyaKay(tangent, eye, softDirection[i], colour);
    sum += mix(groundLight, skyLight, 0.6) * colour * light.r;
  }
  // A ribbon is flat; the strand it stands for is round.
  sum *= 1.0 - 0.35 * vSide * vSide * vCover;
  gl_FragColor = vec4(sum, alpha);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
}`;

/** Into the opacity map: how much of a texel each strand covers, added to every layer it lies in front of. */
export const OPACITY_VERTEX = /* glsl */ `
${RIBBON}
varying float vCover;
void main() {
  Ribbon r = ribbonAt(position.xy, gl_InstanceID, viewMatrix, projectionMatrix);
  vCover = r.cover;
  gl_Position = projectionMatrix * viewMatrix * vec4(r.place, 1.0);
}`;

export const OPACITY_FRAGMENT = /* glsl */ `
uniform sampler2D front;
uniform float layerStep;
varying float vCover;
void main() {
  float x = (gl_FragCoord.z - texelFetch(front, ivec2(gl_FragCoord.xy), 0).r) / layerStep;
  gl_FragColor = vCover * vec4(lessThan(vec4(x), vec4(1.0, 3.0, 7.0, 1e9)));
}`;
