import type { DressWing } from '../../app/dress/wing';
import { useWing } from '../context';

/** The dress wing, for its own panels. */
export const useDress = (): DressWing => useWing<DressWing>('dress');
