import type { HairWing } from '../../app/hair/wing';
import { useWing } from '../context';

/** The hair wing, for its own panels. */
export const useHair = (): HairWing => useWing<HairWing>('hair');
