// What the kernel is told of a step's curves.

import { hashValue } from '../../../core/hash';
import { vertexCount } from '../../../core/model';
import { toIndices } from '../../../core/vertex-set';
import type { CurveLink, CurvePosture, CurveSpec } from '../../../kernel/contract/curve';
import type { Curve, CurvesStep } from '../../../recipe/steps/curves';
import type { ModelResult } from '../../types';
import { vertexSetKey } from '../../vertex-sets';
import { type StepContext, signalOf } from '../step-runner';

/** What the kernel holds for the curves at rest: made once, whatever the pose. */
export function prepareCurves(step: CurvesStep, context: StepContext) {
  const [input] = context.inputs as [ModelResult];
  const held = {
    model: input.key,
    curves: step.curves.map(({ kind, rest, rigid, region, anchor, reach, held }) => [
      kind === 'contour',
      rest,
      rigid,
      region && vertexSetKey(region),
      anchor,
      reach,
      held,
    ]),
    links: linksOf(step),
    options: step.options,
  };
  return context.kernel.hold(
    'prepareCurves',
    hashValue(held),
    () => ({
      model: input.opened.id,
      curves: step.curves.map((curve) => specOf(curve, vertexCount(input.model))),
      links: linksOf(step),
      options: step.options,
    }),
    { ...signalOf(context), onProgress: (fraction) => context.onProgress(0.9 * fraction) },
  );
}

const specOf = ({ kind, rest, rigid, region, anchor, reach, held }: Curve, vertices: number): CurveSpec => ({
  rest: Float64Array.from(rest.flat()),
  role: kind === 'contour' ? 'contour' : 'limb',
  rigid: Uint32Array.from(rigid ?? []),
  region: region === undefined ? null : toIndices(region, vertices),
  anchor: anchor ?? null,
  reach: reach ?? 0,
  held: (held ?? []).map((line) => Float64Array.from(line.flat())),
});

/** A posture as the kernel takes it. */
export const postureOf = ({
  posed,
  base,
  twist,
  scale,
}: Omit<Curve, 'id' | 'kind' | 'rest'>): CurvePosture => ({
  points: Float64Array.from(posed?.flat() ?? []),
  base: Float64Array.from(base ?? []),
  twist: Float64Array.from(twist ?? []),
  scale: Float64Array.from(scale?.flat() ?? []),
});

function linksOf({ curves, links }: CurvesStep): CurveLink[] {
  const number = new Map(curves.map(({ id }, at) => [id, at]));
  return links.map(({ child, parent, at }) => ({
    child: number.get(child)!,
    parent: number.get(parent)!,
    at,
  }));
}
