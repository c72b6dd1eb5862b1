import type { ReportOf } from '../../run/results';
import type { Evaluation } from '../evaluated';
import type { HairFigures } from './state';

/** What the last hair took, as the status bar shows it. */
export function hairFigures(evaluation: Evaluation, before: HairFigures | null): HairFigures | null {
  const { settled, elapsed } = evaluation;
  const report = evaluation.report as ReportOf<'hair'> | null;
  if (!report) return null;
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
