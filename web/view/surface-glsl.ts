// What every surface material adds to three's own shading: painted regions, heat, vertex colours, the
// inside of open surfaces, points as dots and the brush's ring. Lines are measured in pixels by the screen-space gradient
// of the field they are a level of.

export const VERTEX_DECLARATIONS = /* glsl */ `
attribute vec4 regionsLow;
attribute vec4 regionsHigh;
attribute float heat;
attribute vec3 paint;
varying vec4 vRegionsLow;
varying vec4 vRegionsHigh;
varying float vHeat;
varying vec3 vPaint;
varying vec3 vPlace;
uniform float dotSize;    // 0: a surface is drawn
uniform float pixelsTall; // of the picture
`;

/** Points stand as dots that are lit on the side that is seen: the surface through them may be turned either way, and each way in part. */
export const VERTEX_DOT = /* glsl */ `
gl_PointSize = max(1.5, 0.5 * dotSize * projectionMatrix[1][1] * pixelsTall / gl_Position.w);
#ifndef FLAT_SHADED
if (dotSize > 0.0 && dot(vNormal, isOrthographic ? vec3(0.0, 0.0, 1.0) : -mvPosition.xyz) < 0.0) vNormal = -vNormal;
#endif
`;

export const VERTEX_BODY = /* glsl */ `
vRegionsLow = regionsLow;
vRegionsHigh = regionsHigh;
vHeat = heat;
vPaint = paint;
vPlace = position;
`;

export const FRAGMENT_DECLARATIONS = /* glsl */ `
varying vec4 vRegionsLow;
varying vec4 vRegionsHigh;
varying float vHeat;
varying vec3 vPaint;
varying vec3 vPlace;
uniform vec4 regionFill[8];   // linear rgb, opacity
uniform vec4 regionLine[8];   // display rgb, opacity
uniform float regionWidth[8]; // pixels
uniform int regionCount;
uniform float pixelRatio;
uniform bool heatShown;
uniform sampler2D heatMap;
uniform bool paintShown;
uniform vec3 interior;
uniform bool inwards;
uniform float insideShown;
uniform float dotSize;
uniform vec3 brushCentre;
uniform vec3 brushNormal;
uniform vec3 brushSide;
uniform vec3 brushColour;
uniform float brushRadius;    // 0: no brush
uniform bool brushDashed;

float slope(float field) { return max(length(vec2(dFdx(field), dFdy(field))), 1e-7); }

// The regions' part of the picture: the tint joins the clay before light falls on it, the line lies over all.
// A tint would falsify the colours of a heat map: there the line must do.
void paintRegion(float field, vec4 fill, vec4 line, float width, inout vec3 base, inout vec4 over) {
  float inside = (field - 0.5) / slope(field);
  if (!heatShown) base = mix(base, fill.rgb, fill.a * clamp(inside + 0.5, 0.0, 1.0));
  float half_ = 0.5 * width * pixelRatio;
  float cover = line.a * clamp(half_ + 0.5 - abs(inside - half_), 0.0, 1.0);
  over = vec4(mix(over.rgb * over.a, line.rgb, cover), mix(over.a, 1.0, cover));
  over.rgb /= max(over.a, 1e-4);
}

vec3 toLinear(vec3 c) {
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, vec3(lessThanEqual(c, vec3(0.04045))));
}
`;

/**
 * After the material knows its own colour, before light. Leaves the lines in `over`.
 *
 * @param shades  what layers do to `base`
 */
export const fragmentColour = (shades: string): string => /* glsl */ `
if (dotSize > 0.0 && length(gl_PointCoord - 0.5) > 0.5) discard;
vec4 over = vec4(0.0);
{
  vec3 base = diffuseColor.rgb;
  if (heatShown) base = texture2D(heatMap, vec2(clamp(vHeat, 0.0, 1.0) * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb;
  else if (paintShown) base = toLinear(vPaint);
  // Only where one looks into it: along an outline near and far side are as one.
  vec3 across = normalize(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
  float open_ = smoothstep(0.06, 0.3, abs(dot(across, normalize(vViewPosition))));
  if (gl_FrontFacing == inwards) base = mix(base, interior, 0.85 * insideShown * open_);
  if (regionCount > 0) {
    paintRegion(vRegionsLow.x, regionFill[0], regionLine[0], regionWidth[0], base, over);
    paintRegion(vRegionsLow.y, regionFill[1], regionLine[1], regionWidth[1], base, over);
    paintRegion(vRegionsLow.z, regionFill[2], regionLine[2], regionWidth[2], base, over);
    paintRegion(vRegionsLow.w, regionFill[3], regionLine[3], regionWidth[3], base, over);
  }
  if (regionCount > 4) {
    paintRegion(vRegionsHigh.x, regionFill[4], regionLine[4], regionWidth[4], base, over);
    paintRegion(vRegionsHigh.y, regionFill[5], regionLine[5], regionWidth[5], base, over);
    paintRegion(vRegionsHigh.z, regionFill[6], regionLine[6], regionWidth[6], base, over);
    paintRegion(vRegionsHigh.w, regionFill[7], regionLine[7], regionWidth[7], base, over);
  }
  ${shades}
  diffuseColor.rgb = base;
}
`;

/** After tone mapping and encoding: overlay colours are what the palette says. */
export const FRAGMENT_OVERLAY = /* glsl */ `
gl_FragColor.rgb = mix(gl_FragColor.rgb, over.rgb, over.a);
if (brushRadius > 0.0) {
  vec3 arm = vPlace - brushCentre;
  float reach = length(arm);
  float away = (reach - brushRadius) / slope(reach);
  float cover = clamp(0.9 * pixelRatio + 0.5 - abs(away), 0.0, 1.0);
  float halo = clamp(2.4 * pixelRatio + 0.5 - abs(away), 0.0, 1.0);
  float turn = atan(dot(arm, cross(brushNormal, brushSide)), dot(arm, brushSide)) / 6.2831853;
  if (brushDashed) {
    float dash = abs(fract(turn * 24.0) - 0.5);
    float gap = clamp((dash - 0.22) * 6.2831853 / 24.0 * brushRadius / slope(reach) + 0.5, 0.0, 1.0);
    cover *= gap;
    halo *= gap;
  }
  gl_FragColor.rgb = mix(gl_FragColor.rgb, brushColour, 0.07 * clamp(0.5 - away, 0.0, 1.0));
  gl_FragColor.rgb = mix(gl_FragColor.rgb, vec3(0.0), 0.35 * halo);
  gl_FragColor.rgb = mix(gl_FragColor.rgb, brushColour, cover);
}
`;
