import type { Evaluation } from '../evaluation';
import type { HairFigures } from './state';

/** What the last hair took, as the status bar shows it. */
export function hairFigures(evaluation: Evaluation, before: HairFigures | null): HairFigures | null {
  const { report, settled, elapsed } = evaluation;
  if (!report) return null;
  const { update = 0, field = 0, grow = 0 } = report.seconds;
  return {
    constraints: Number(report.constraints ?? 0),
    grid: report.grid as HairFigures['grid'],
    strands: Number(report.strands ?? 0),
    update: 1000 * update,
    field: 1000 * field,
    grow: 1000 * grow,
    stroke: settled ? elapsed : (before?.stroke ?? null),
  };
}
