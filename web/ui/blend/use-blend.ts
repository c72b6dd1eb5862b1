import type { BlendWing } from '../../app/blend/wing';
import { useWing } from '../context';

/** The blend wing, for its own panels. */
export const useBlend = (): BlendWing => useWing<BlendWing>('blend');
