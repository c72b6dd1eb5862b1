import type { Evaluation } from './evaluated';
import { tCode } from './i18n';

/** Why there is no result, in a wing's own words where it has some; `null` where there is one. @param prefix  of its words */
export const problemText = (shown: Evaluation | null, prefix: string): string | null =>
  shown?.problem
    ? tCode(prefix, shown.problem.code, 'error.unknown', { detail: shown.problem.message })
    : null;
