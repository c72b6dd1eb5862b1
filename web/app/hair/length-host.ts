// The app's side of painting lengths: factors in, edits of the recipe out, hair that follows the brush.

import { replaceStep } from '../../recipe/edit';
import type { Recipe } from '../../recipe/recipe';
import { lengthFactors } from '../../run/steps/hair';
import type { Brush } from '../../tools/brush-stroke';
import { type LengthHost, type LengthScene, lengthMapOf } from '../../tools/hair/length-tool';
import type { PaintVerb } from '../../tools/paint-tool';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { AppHairHost } from './host';
import type { HairState } from './state';

export class AppLengthHost implements LengthHost {
  readonly view: LengthHost['view'];

  constructor(
    private readonly hair: AppHairHost,
    private readonly parts: Pick<WingParts, 'document'>,
    private readonly own: Pick<HairState, 'lengthBrush'>,
  ) {
    this.view = hair.view;
  }

  brush(): Brush {
    return this.hair.brush();
  }

  lengthScene(): LengthScene | null {
    const scene = this.hair.scalpScene();
    const { step } = this.hair;
    if (!scene || !step) return null;
    const { graph, scalp, mirrored } = scene;
    const skin = new Set(scalp);
    return {
      graph,
      // Hair grows from the scalp alone.
      mirrored: (vertices) => mirrored(vertices).filter((v) => skin.has(v)),
      factors: lengthFactors(step.length.map, graph.vertexCount),
      factor: this.own.lengthBrush.peek(),
    };
  }

  showPaint(paint: object | null): void {
    if (!paint) this.parts.document.cancel();
  }

  previewLengths(factors: Float32Array): void {
    const { document } = this.parts;
    const recipe = this.#with(factors);
    if (recipe) document.preview(recipe, document.selection);
  }

  commitLengths(verb: PaintVerb, factors: Float32Array): void {
    const recipe = this.#with(factors);
    if (recipe) this.parts.document.commit(t(`history.hair.${verb}-length`), recipe);
  }

  #with(factors: Float32Array): Recipe | null {
    const { step } = this.hair;
    if (!step) return null;
    const length = { ...step.length, map: lengthMapOf(factors) };
    return replaceStep(this.parts.document.recipe, { ...step, length });
  }
}
