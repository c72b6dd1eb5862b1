import { FrontSide, type Material, ShaderLib, type WebGLProgramParametersWithUniforms } from 'three';
import { expect, test } from 'vitest';
import { SurfaceMaterials } from '../../web/view/surface-material';
import type { SurfaceShade } from '../../web/view/surface-shade';

const LOOK = { shading: 'clay', smooth: true } as const;

const veil = (depth: number): SurfaceShade => ({
  id: 'veil',
  uniforms: { veilDepth: { value: depth } },
  vertexDeclarations: 'attribute float veiled;',
  vertexBody: 'vVeiled = veiled;',
  declarations: 'uniform float veilDepth;',
  colour: 'base *= veilDepth;',
  light: 'reflectedLight.directDiffuse *= veilDepth;',
});

/** What three.js would compile of a material. */
function compiled(material: Material): WebGLProgramParametersWithUniforms {
  const { vertexShader, fragmentShader } = ShaderLib.standard;
  const program = { vertexShader, fragmentShader, uniforms: {} } as WebGLProgramParametersWithUniforms;
  material.onBeforeCompile(program, undefined as never);
  return program;
}

test('a shade’s code is in the surface’s program, each part in its place, while the layer is there', () => {
  const materials = new SurfaceMaterials();
  const material = materials.of(LOOK, FrontSide);
  const bare = material.customProgramCacheKey();
  expect(compiled(material).fragmentShader).not.toContain('veil');
  materials.setShades([veil(2)]);
  expect(material.customProgramCacheKey()).not.toBe(bare);
  const { vertexShader, fragmentShader } = compiled(material);
  const order = [
    'uniform float veilDepth;',
    '#include <color_fragment>',
    'base *= veilDepth;',
    'diffuseColor.rgb = base;',
    '#include <lights_fragment_end>',
    'reflectedLight.directDiffuse *= veilDepth;',
  ].map((part) => fragmentShader.indexOf(part));
  expect(order.every((at, i) => at >= 0 && (i === 0 || at > order[i - 1]!))).toBe(true);
  expect(vertexShader.indexOf('attribute float veiled;')).toBeLessThan(
    vertexShader.indexOf('vVeiled = veiled;'),
  );
  materials.setShades([]);
  expect(material.customProgramCacheKey()).toBe(bare);
  expect(compiled(material).fragmentShader).not.toContain('veil');
});

test('programs are made anew when the shades are others, not when another layer of a kind takes its place', () => {
  const materials = new SurfaceMaterials();
  const material = materials.of(LOOK, FrontSide);
  const versions = [[], [veil(1)], [veil(2)], [veil(2)], []].map((shades) => {
    materials.setShades(shades);
    return material.version;
  });
  const [none, first, second, same, gone] = versions;
  expect(first).toBeGreaterThan(none!);
  expect([second, same]).toEqual([first, first]);
  expect(gone).toBeGreaterThan(first!);
});

test('a program that was made once has the values of the layer that is there now', () => {
  const materials = new SurfaceMaterials();
  const material = materials.of(LOOK, FrontSide);
  const first = veil(1);
  materials.setShades([first]);
  const { uniforms } = compiled(material);
  expect(uniforms.veilDepth!.value).toBe(1);
  first.uniforms.veilDepth!.value = 5;
  expect(uniforms.veilDepth!.value).toBe(5);
  materials.setShades([]);
  expect(uniforms.veilDepth!.value).toBeUndefined();
  // The program without shades may be made last: its uniforms then serve the one with them, too.
  const bare = compiled(material);
  materials.setShades([veil(7)]);
  expect([uniforms.veilDepth!.value, bare.uniforms.veilDepth!.value]).toEqual([7, 7]);
});
