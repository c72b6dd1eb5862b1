import type { MergeWing } from '../../app/merge/wing';
import { useWing } from '../context';

/** The merge wing, for its own panels. */
export const useMerge = (): MergeWing => useWing<MergeWing>('merge');
