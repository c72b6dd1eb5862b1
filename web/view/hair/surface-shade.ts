import type { IUniform } from 'three';
import type { SurfaceShade } from '../surface-shade';
import { OPACITY_LOOKUP } from './strand-glsl';

/**
 * What hair takes from the light that falls on a surface, and how its roots tint the skin.
 *
 * @param uniforms  of the opacity maps, and `hairShade`, `hairShadeLow`, `hairShadeSize`, `hairTint`
 */
export const hairShade = (uniforms: Readonly<Record<string, IUniform>>): SurfaceShade => ({
  id: 'hair',
  uniforms,
  vertexDeclarations: /* glsl */ `
attribute float rooted;
varying float vRooted;
`,
  vertexBody: 'vRooted = rooted;',
  declarations: /* glsl */ `
precision highp sampler3D;
${OPACITY_LOOKUP}
uniform sampler3D hairShade;
uniform vec3 hairShadeLow;
uniform float hairShadeSize;
uniform vec3 hairTint;
varying float vRooted;
`,
  colour: 'if (!heatShown) base = mix(base, base * hairTint, 0.6 * smoothstep(0.25, 1.0, vRooted));',
  // The key light is the only one that is not part of the room.
  light: /* glsl */ `
{
  float key = exp(-keyLightAt(vPlace, 0.0, 0.0).x);
  reflectedLight.directDiffuse *= key;
  reflectedLight.directSpecular *= key;
  float open_ = texture(hairShade, clamp((vPlace - hairShadeLow) / hairShadeSize, 0.0, 1.0)).r;
  reflectedLight.indirectDiffuse *= open_;
  reflectedLight.indirectSpecular *= open_;
}
`,
});
