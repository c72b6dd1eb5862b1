import { expect, test } from 'vitest';
import { drawsInSoftware } from '../../web/view/software';

test('drawing without a graphics card is known by the name of what draws', () => {
  const gl = (name: string) => ({ getExtension: () => null, getParameter: () => name }) as never;
  expect(drawsInSoftware(gl('ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)))'))).toBe(true);
  expect(drawsInSoftware(gl('ANGLE (Apple, Apple M1 Pro, OpenGL 4.1)'))).toBe(false);
});
