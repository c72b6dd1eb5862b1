import type { PointerSample } from '../../view/types';
import { Drawing, type Drawn } from '../stroke/gesture';
import type { HairEdit, HairEditLabel, HairHost, HairRemark } from './host';
import type { CurveKind } from './style';

/** One stroke from press to release, which the hair follows while it is drawn. */
export const drawing = (
  host: HairHost,
  drawn: Drawn<HairEdit, HairEditLabel, HairRemark, CurveKind>,
  first: PointerSample,
): Drawing<HairEdit, HairEditLabel, HairRemark, CurveKind> => {
  // A new curve is edited on a surface that faces whoever drew it.
  const finished = drawn.label.startsWith('add-') ? () => host.rebuildSupport() : undefined;
  return new Drawing(host, finished ? { ...drawn, finished } : drawn, first);
};
