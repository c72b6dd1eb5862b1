import type { Model } from '../core/model';

// Formats without a place for unit and axis carry them in a comment, so that a model keeps them on its way.

/** The comments that state what the model knows of its unit and axis. */
export function unitComments(model: Model): string[] {
  const comments: string[] = [];
  if (model.unitMetres !== undefined) comments.push(`unit: ${model.unitMetres} m`);
  if (model.upAxis !== undefined) comments.push(`up: ${model.upAxis}`);
  return comments;
}

/** What comments say of unit and axis, and the comments that say something else. */
export function fromUnitComments(comments: readonly string[]): {
  units: Pick<Model, 'unitMetres' | 'upAxis'>;
  others: string[];
} {
  const units: { unitMetres?: number; upAxis?: 'y' | 'z' } = {};
  const others: string[] = [];
  for (const comment of comments) {
    const unit = Number(/^unit: (\S+) m$/.exec(comment)?.[1]);
    const up = /^up: ([yz])$/.exec(comment)?.[1];
    if (unit > 0 && unit < Infinity) units.unitMetres = unit;
    else if (up) units.upAxis = up as 'y' | 'z';
    else others.push(comment);
  }
  return { units, others };
}
