import type { MatchWing } from '../../app/match/wing';
import { useWing } from '../context';

/** The match wing, for its own panels. */
export const useMatch = (): MatchWing => useWing<MatchWing>('match');
