import type { DeformWing } from '../../app/deform/wing';
import { useWing } from '../context';

/** The deform wing, for its own panels. */
export const useDeform = (): DeformWing => useWing<DeformWing>('deform');
