import { BufferAttribute, Group } from 'three';
import type { Layer, LayerContext, LayerKind } from '../layer';
import type { ModelView } from '../model-view';
import type { SurfaceShade } from '../surface-shade';
import type { ViewSpace } from '../view-space';
import type { LevelLines, LevelsPort } from './types';

/** CSS pixels to either side. */
const HALF_WIDTH = 0.8;

/** Lines along which a field has the same value, drawn by the surface itself: they move with it. */
class LevelsOverlay implements Layer, LevelsPort {
  readonly group = new Group();
  #lines: LevelLines | null = null;
  #model: ModelView | undefined;
  readonly #uniforms = { levelSteps: { value: 0 } };
  readonly #shade = levelShade(this.#uniforms);

  constructor(private readonly context: LayerContext) {}

  get shade(): SurfaceShade | undefined {
    return this.#lines ? this.#shade : undefined;
  }

  place(_: ViewSpace, model: ModelView | undefined): void {
    if (model !== this.#model) this.#lines = null;
    this.#model = model;
  }

  setLevels(lines: LevelLines | null): void {
    const fits = lines !== null && lines.values.length === (this.#model?.model.positions.length ?? 0) / 3;
    this.#lines = fits ? lines : null;
    this.#uniforms.levelSteps.value = this.#lines?.steps ?? 0;
    if (this.#lines) this.#model!.geometry.setAttribute('level', new BufferAttribute(this.#lines.values, 1));
    this.context.redraw();
  }

  dispose(): void {
    this.#model?.geometry.deleteAttribute('level');
  }
}

export const LEVELS: LayerKind<LevelsPort> = {
  id: 'levels',
  make: (context) => new LevelsOverlay(context),
};

const levelShade = (uniforms: SurfaceShade['uniforms']): SurfaceShade => ({
  id: 'levels',
  uniforms,
  vertexDeclarations: /* glsl */ `
attribute float level;
varying float vLevel;
`,
  vertexBody: 'vLevel = level;',
  declarations: /* glsl */ `
uniform float levelSteps;
varying float vLevel;
`,
  // Where steps lie closer than a few pixels the lines fade into an even shade.
  colour: /* glsl */ `
{
  float steps = vLevel * levelSteps;
  float wide = slope(steps) * pixelRatio;
  float away = abs(fract(steps + 0.5) - 0.5) / wide;
  float line = clamp(${HALF_WIDTH.toFixed(1)} + 0.5 - away, 0.0, 1.0) * clamp(1.6 - 4.0 * wide, 0.25, 1.0);
  float ends = step(0.5, steps) * step(steps, levelSteps - 0.5);
  base = mix(base, vec3(0.02, 0.09, 0.12), 0.8 * line * ends);
}
`,
  light: '',
});
