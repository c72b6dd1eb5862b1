import type { Model } from '../../../core/model';
import { vertexCount } from '../../../core/model';
import { toIndices } from '../../../core/vertex-set';
import type { HairStep } from '../../../recipe/recipe';

/** The vertices hair grows from: those the step names, else those the model brings. */
export const scalpOf = ({ scalp }: Pick<HairStep, 'scalp'>, model: Model): Uint32Array =>
  scalp ? toIndices(scalp, vertexCount(model)) : (model.vertexSets?.scalp ?? new Uint32Array());
