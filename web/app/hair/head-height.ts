// What the sizes of hair are measured by.

import type { Model } from '../../core/model';
import type { Evaluation } from '../evaluated';

/** The head's height in model units as the kernel found it from the scalp; until then how tall the model is. */
export function headHeight({ report, shown }: Pick<Evaluation, 'report' | 'shown'>): number {
  return report?.type === 'hair' ? report.headHeight : tallness(shown.model);
}

/** How far a model reaches along its up axis. */
export function tallness({ positions, upAxis }: Model): number {
  let [low, high] = [Infinity, -Infinity];
  for (let at = upAxis === 'z' ? 2 : 1; at < positions.length; at += 3) {
    const x = positions[at]!;
    if (!Number.isFinite(x)) continue;
    low = Math.min(low, x);
    high = Math.max(high, x);
  }
  return Math.max(0, high - low);
}
