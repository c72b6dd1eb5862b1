// Where two models shall meet, found from rough marks: openings where the marks touch any, the optimal boundary
// between two patches, or the edges of the marks.

import { LissomError } from '../../core/errors';
import type { Mark } from '../../tools/merge/host';
import { arcLengths, type Loop } from '../../tools/merge/loops';
import { featureWithin, loopsTouched, tidied } from '../../tools/merge/marks';
import type { MergeBoundary, MergeSide } from '../../tools/merge/pins';
import { t } from '../i18n';
import type { SideAid } from './aids';

export type Meeting =
  | { readonly kind: 'loops'; readonly boundaries: readonly MergeBoundary[] }
  /** Along the optimal boundary; the marks made into patches, the feature found where none was painted. */
  | { readonly kind: 'optimal'; readonly marks: Readonly<Record<Mark, Uint32Array>> };

export interface MarkedPart extends SideAid {
  readonly marks: Partial<Readonly<Record<Mark, Uint32Array>>>;
  readonly loopsAround: (vertices: Uint32Array) => Promise<readonly Uint32Array[]>;
}

/**
 * @param cut  joins the models along the edges of the marks rather than seeking the best line
 * @throws LissomError  in words that say what is still to be marked
 */
export async function meetingOf(source: MarkedPart, target: MarkedPart, cut: boolean): Promise<Meeting> {
  const feature = source.marks.feature ?? new Uint32Array();
  const region = patch(source, [...(source.marks.source ?? []), ...feature]);
  const goal = patch(target, target.marks.target ?? []);
  const openings = {
    source: openingsOf(source, region),
    target: openingsOf(target, goal),
  };
  const lacking = (['source', 'target'] as const).filter(
    (side) => openings[side].length === 0 && (side === 'source' ? region : goal).length === 0,
  );
  if (lacking.length > 0) throw unmarked(lacking);
  if (!cut && openings.source.length === 0 && openings.target.length === 0) {
    const whole = feature.length > 0 ? feature : middleOf(source, region);
    return { kind: 'optimal', marks: { source: region, feature: whole, target: goal } };
  }
  const loops = {
    source: openings.source.length > 0 ? openings.source : await edges(source, region, 'source'),
    target: openings.target.length > 0 ? openings.target : await edges(target, goal, 'target'),
  };
  const count = Math.min(loops.source.length, loops.target.length);
  const boundaries = Array.from({ length: count }, (_, i) => ({
    source: [...loops.source[i]!],
    target: [...loops.target[i]!],
    keys: [],
    sourceKeep: [],
    targetKeep: [],
  }));
  return { kind: 'loops', boundaries };
}

/** The openings a mark touches; without a mark the only one that there is. */
function openingsOf({ loops }: SideAid, mark: Uint32Array): readonly Loop[] {
  if (mark.length > 0) return loopsTouched(loops, mark);
  return loops.length === 1 ? loops : [];
}

const patch = ({ graph, positions }: SideAid, mark: Iterable<number>): Uint32Array => {
  const marked = Uint32Array.from(mark);
  return marked.length > 0 ? tidied(graph, marked, positions.length / 3) : marked;
};

function middleOf({ graph, positions }: SideAid, region: Uint32Array): Uint32Array {
  const middle = featureWithin(graph, region, positions);
  if (middle.length === 0) throw new LissomError('merge-no-middle', t('error.merge-no-middle'));
  return middle;
}

/** The longest path around a mark, what is kept to its left: the painted side of the part, the rest of the target. */
async function edges(part: MarkedPart, mark: Uint32Array, side: MergeSide): Promise<readonly Loop[]> {
  const around = await part.loopsAround(mark);
  const length = (loop: Uint32Array) => arcLengths([...loop], part.positions).at(-1)!;
  const longest = [...around].sort((a, b) => length(b) - length(a))[0];
  if (!longest) throw new LissomError('merge-no-edge', t('error.merge-no-edge'));
  return [side === 'source' ? [...longest] : [...longest].reverse()];
}

function unmarked(lacking: readonly MergeSide[]): LissomError {
  if (lacking.length === 2) return new LissomError('merge-unmarked', t('error.merge-unmarked'));
  return lacking[0] === 'source'
    ? new LissomError('merge-unmarked-source', t('error.merge-unmarked-source'))
    : new LissomError('merge-unmarked-target', t('error.merge-unmarked-target'));
}
