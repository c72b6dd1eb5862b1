import type { Evaluation } from '../evaluation';
import type { HairFigures } from './state';

/** What the last hair took, as the status bar shows it. */
export function hairFigures(evaluation: Evaluation, before: HairFigures | null): HairFigures | null {
  const { report, settled, elapsed } = evaluation;
  if (report?.type !== 'hair') return null;
  const { update = 0, field = 0, grow = 0 } = report.seconds;
  return {
    constraints: report.constraints,
    grid: report.grid,
    strands: report.strands,
    update: 1000 * update,
    field: 1000 * field,
    grow: 1000 * grow,
    stroke: settled ? elapsed : (before?.stroke ?? null),
  };
}
