// The app's side of painting lengths: factors in, edits of the recipe out, hair that follows the brush.

import type { Recipe } from '../../recipe/recipe';
import { lengthFactors } from '../../run/steps/hair';
import type { Brush } from '../../tools/brush-stroke';
import { type LengthHost, type LengthScene, lengthMapOf } from '../../tools/hair/length-tool';
import type { PaintVerb } from '../../tools/paint-tool';
import type { Document } from '../document';
import { t } from '../i18n';
import type { State } from '../state';
import type { AppHairHost } from './host';
import { hairStepById, withHairStep } from './steps';

interface Parts {
  readonly state: State;
  readonly document: Document;
  readonly hair: AppHairHost;
}

export class AppLengthHost implements LengthHost {
  readonly view: LengthHost['view'];

  constructor(private readonly parts: Parts) {
    this.view = parts.hair.view;
  }

  brush(): Brush {
    return this.parts.hair.brush();
  }

  lengthScene(): LengthScene | null {
    const scene = this.parts.hair.scalpScene();
    const step = this.#step;
    if (!scene || !step) return null;
    const { graph, scalp, mirrored } = scene;
    const skin = new Set(scalp);
    return {
      graph,
      // Hair grows from the scalp alone.
      mirrored: (vertices) => mirrored(vertices).filter((v) => skin.has(v)),
      factors: lengthFactors(step.length.map, graph.vertexCount),
      factor: this.parts.state.hair.lengthBrush.peek(),
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

  get #step() {
    const { document } = this.parts;
    return hairStepById(document.recipe, document.selection.step);
  }

  #with(factors: Float32Array): Recipe | null {
    const step = this.#step;
    if (!step) return null;
    const length = { ...step.length, map: lengthMapOf(factors) };
    return withHairStep(this.parts.document.recipe, { ...step, length });
  }
}
