import type { CurvesWing } from '../../app/curves/wing';
import { useWing } from '../context';

/** The curves wing, for its own panels. */
export const useCurves = (): CurvesWing => useWing<CurvesWing>('curves');
