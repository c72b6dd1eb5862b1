import { ACESFilmicToneMapping, PCFShadowMap, WebGLRenderer } from 'three';
import { LissomError } from '../core/errors';

/**
 * @param test  for tests: no antialiasing
 * @throws LissomError  `webgl-missing`: no WebGL 2
 */
export function rendererFor(canvas: HTMLCanvasElement, test = false): WebGLRenderer {
  let renderer: WebGLRenderer;
  try {
    renderer = new WebGLRenderer({
      canvas,
      antialias: !test,
      powerPreference: 'high-performance',
    });
  } catch {
    throw new LissomError(
      'webgl-missing',
      'This browser offers no WebGL 2. Switch hardware acceleration on in its settings, or use another browser.',
      'crash',
    );
  }
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.autoUpdate = false;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}
