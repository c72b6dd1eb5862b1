// What light does in hair. Angles as Marschner et al., "Light scattering from human hair fibers" (2003):
// θ from the plane across the strand, φ around it; the tangent points from root to tip.

import { OPACITY_LOOKUP, RIBBON, STRAND_POINTS } from './strand-glsl';

/** One texel per point of a strand, in the order of the points' texture. */
export const LIGHT_FRAGMENT = /* glsl */ `
precision highp sampler3D;
${STRAND_POINTS}
${OPACITY_LOOKUP}
uniform vec3 hairColour;       // linear
uniform float colourVariation; // 0..1
uniform bool natural;
uniform vec3 keyDirection;
uniform vec3 keyLight;
uniform vec3 softDirection[3];
uniform vec3 softLight[3];
uniform float softSpread[3];   // half the lamp's angle
uniform vec3 fillDirection;    // the lamp that only lightens the shaded side
uniform vec3 fillLight;
uniform float fillSpread;
uniform vec3 skyLight;
uniform vec3 groundLight;
uniform sampler3D lightGrid;   // openness; what is left of the three soft lights after a quarter of the way
uniform vec3 gridLow;
uniform float gridSize;
uniform vec3 eyePlace;
uniform vec3 eyeBack;          // from the scene to the eye
uniform bool eyeFar;           // orthographic

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
  // Roughness of the lobes 1 : ½ : 2, shifts −2 : 1 : 3 (Marschner 2003), widened by the lamp.
  float soft = 0.085 + 0.35 * spread;
  vec3 r = vec3(1.4 * bell(half_ + fibre.tilt, soft) * 0.25 * cosHalfPhi * fresnel);
  // Around the strand: fits of the thick-cylinder integrals by Karis, "Physically based hair shading" (2016).
  vec3 tt = 0.5 * bell(half_ - 0.5 * fibre.tilt, 0.6 * soft) * exp(-3.65 * cosPhi - 3.98) * fibre.through;
  vec3 trt = bell(half_ - 1.5 * fibre.tilt, 1.7 * soft) * exp(17.0 * cosPhi - 16.78) * 0.06 * fibre.through * fibre.through;
  float cosines = cosLight / max(0.25, cosDiff * cosDiff);
  vec3 single = (r + trt) * near + tt * far * mix(0.35, 1.0, near);
  // What has bounced between strands has lost its direction but for a preference for the lit side.
  float wrap = (0.45 + 0.55 * dot(normalize(b), towards)) * cosLight;
  vec3 many = 0.78 * colour * max(0.0, 0.25 + 0.75 * wrap) / PI;
  return single * cosines + many * far * mix(0.7, 1.0, near);
}

// Kajiya & Kay, "Rendering fur with three dimensional textures" (1989); both directions point away from the strand.
vec3 kajiyaKay(vec3 tangent, vec3 eye, vec3 towards, vec3 colour) {
  float cosLight = dot(tangent, towards);
  float cosEye = dot(tangent, eye);
  float sinLight = sqrt(max(0.0, 1.0 - cosLight * cosLight));
  float sinEye = sqrt(max(0.0, 1.0 - cosEye * cosEye));
  float shine = pow(max(0.0, sinLight * sinEye - cosLight * cosEye), 40.0);
  return colour * sinLight / PI + vec3(0.1 * shine);
}

vec4 lightAt(vec3 place) { return texture(lightGrid, clamp((place - gridLow) / gridSize, 0.0, 1.0)); }

// Whether a place lies on the hair's side towards a direction, 0..1: out is where it opens.
float openTo(vec3 place, vec3 direction) {
  float d = 1.5 * gridSize / float(textureSize(lightGrid, 0).x);
  vec3 out_ = vec3(lightAt(place + vec3(d, 0, 0)).r - lightAt(place - vec3(d, 0, 0)).r,
                   lightAt(place + vec3(0, d, 0)).r - lightAt(place - vec3(0, d, 0)).r,
                   lightAt(place + vec3(0, 0, d)).r - lightAt(place - vec3(0, 0, d)).r);
  return smoothstep(-0.2, 0.8, dot(out_, direction) / max(length(out_), 1e-4));
}

vec3 colourOf(uint seed, uint group, float along) {
  float lighter = unit(seed + 0x68bc21ebu) - 0.5;
  float warmer = unit(seed + 0x02e5be93u) - 0.5;
  float ofGroup = group == 0u ? 0.0 : unit(group + 0x7f4a7c15u) - 0.5;
  float amount = 1.6 * colourVariation;
  vec3 colour = hairColour * exp(amount * (lighter + 0.7 * ofGroup));
  colour *= exp(amount * 0.5 * warmer * vec3(0.5, 0.0, -0.7));
  // Sun and wear bleach towards the tips.
  if (natural) colour *= mix(0.78, 1.22, along);
  // Filmic tones deepen dark colours; hair in the shade would look dyed.
  colour = mix(colour, vec3(dot(colour, vec3(0.2126, 0.7152, 0.0722))), 0.18);
  return min(colour, vec3(0.94));
}

void main() {
  int number = int(gl_FragCoord.y) * textureSize(strandPoints, 0).x + int(gl_FragCoord.x);
  int strand = number / perStrand;
  int point = number - strand * perStrand;
  uvec4 texel = texelOf(strand, point);
  vec3 place = placeOf(texel);
  vec3 along = alongOf(strand, point);
  vec3 tangent = along / max(length(along), 1e-9);
  vec3 eye = eyeFar ? eyeBack : normalize(eyePlace - place);
  uint seed = uint(strand);
  vec3 colour = colourOf(seed, texel.w, float(point) / float(perStrand - 1));
  vec4 light = lightAt(place);
  vec3 softDepth = -4.0 * log(max(light.gba, 1.0 / 512.0));
  vec2 key = keyLightAt(place, 0.3, 3.0);
  // Strands absorb per crossing what, over the many crossings in a head of hair, makes this colour:
  // Chiang et al., "A practical and controllable hair and fur model" (2016), its fit at roughness 0.3.
  vec3 root = log(max(colour, vec3(0.002))) / 5.89;
  vec3 sigma = root * root;
  Fibre fibre = Fibre(tangent, eye, dot(tangent, eye), exp(-2.6 * sigma), 0.1 + 0.14 * (unit(seed ^ 0x5bd1e995u) - 0.5));
  // Loss per crossed strand of light that goes on forwards.
  vec3 loss = 0.55 * (1.0 - exp(-1.6 * sigma));
  loss = 0.1 + mix(loss, vec3(dot(loss, vec3(0.33))), 0.4);

  vec3 sum;
  if (natural) {
    sum = keyLight * key.y * lit(fibre, keyDirection, 0.05, colour, exp(-0.9 * key.x), exp(-loss * key.x));
    for (int i = 0; i < 3; i++) {
      float depth = softDepth[i];
      sum += softLight[i] * lit(fibre, softDirection[i], softSpread[i], colour, exp(-0.9 * depth), exp(-loss * depth));
    }
    float filled = openTo(place, fillDirection) * light.r;
    sum += fillLight * lit(fibre, fillDirection, fillSpread, colour, filled, vec3(filled));
    vec3 facing = normalize(eye - fibre.sinEye * tangent);
    vec3 around = mix(groundLight, skyLight, 0.5 + 0.4 * facing.y + 0.1 * eye.y);
    // Openness squared: light that came in has to come out again.
    sum += around * colour * light.r * mix(0.6, 1.0, light.r);
    // The room mirrored in the strand, the mean over the cone of its reflection: what gives dark hair its form.
    float mirrored = 0.75 * sqrt(1.0 - fibre.sinEye * fibre.sinEye) * facing.y - fibre.sinEye * tangent.y;
    sum += 0.055 * mix(groundLight, skyLight, 0.5 + 0.5 * mirrored) * light.r;
  } else {
    sum = keyLight * key.y * exp(-0.9 * key.x) * kajiyaKay(tangent, eye, keyDirection, colour);
    for (int i = 0; i < 3; i++) sum += softLight[i] * exp(-softDepth[i]) * kajiyaKay(tangent, eye, softDirection[i], colour);
    sum += mix(groundLight, skyLight, 0.6) * colour * light.r;
  }
  gl_FragColor = vec4(sum, 1.0);
}`;

export const SHADE_VERTEX = /* glsl */ `
${RIBBON}
uniform sampler2D strandLight;
uniform uint frame;       // of a resting picture: which strands stand for those too thin to see
varying vec3 vLight;
varying float vSide;
varying float vCover;
flat varying float vChance;
void main() {
  Ribbon r = ribbonAt(position.xy, gl_InstanceID, viewMatrix, projectionMatrix);
  vLight = texelFetch(strandLight, cellOf(numberOf(gl_InstanceID, int(position.y))), 0).rgb;
  vSide = position.x;
  vCover = r.cover;
  vChance = unit(uint(gl_InstanceID) * 2u + 0x9e3779b9u * frame);
  gl_Position = projectionMatrix * viewMatrix * vec4(r.place, 1.0);
}`;

export const SHADE_FRAGMENT = /* glsl */ `
uniform bool multisampled;
varying vec3 vLight;
varying float vSide;
varying float vCover;
flat varying float vChance;

void main() {
  // Of strands thinner than a pixel some stand for all, whole: grain along strands looks like hair, across it like noise.
  float alpha = vCover >= 1.0 ? 1.0 : clamp(2.0 * (vCover - vChance) + 0.5, 0.0, 1.0);
  if (multisampled ? alpha <= 0.0 : alpha < 0.5) discard;
  // A ribbon is flat; the strand it stands for is round.
  gl_FragColor = vec4(vLight * (1.0 - 0.35 * vSide * vSide * vCover), alpha);
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
