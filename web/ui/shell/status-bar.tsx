import type { HairFigures } from '../../app/hair/state';
import { formatNumber, t } from '../../app/i18n';
import type { Figures } from '../../app/state';
import { useApp } from '../context';
import { Button } from '../controls/button';

/** What a click and a drag do now; what the kernel is at; its figures. */
export function StatusBar() {
  const { state } = useApp();
  const figures = state.figures.value;
  const busy = state.busy.value;
  const hair = state.workspace.value === 'hair' ? state.hair.figures.value : null;
  // Leftmost, so that its coming and going moves nothing else.
  const parts = [
    state.previewing.value && figures.fps >= 2 && t('ui.figure.fps', { count: Math.round(figures.fps) }),
    ...(hair ? hairParts(hair) : deformParts(figures)),
  ].filter((part): part is string => typeof part === 'string');
  return (
    <footer class="status-bar">
      <span class="status-text" role="status">
        {state.status.value}
      </span>
      {busy && (
        <span class="status-busy">
          <span>
            {busy.label}
            {busy.fraction !== null && ` ${Math.round(busy.fraction * 100)} %`}
          </span>
          <span
            class="progress"
            role="progressbar"
            aria-label={busy.label}
            aria-valuemin={0}
            aria-valuemax={100}
            {...(busy.fraction === null ? {} : { 'aria-valuenow': Math.round(busy.fraction * 100) })}
          >
            <div style={{ width: `${(busy.fraction ?? 0.3) * 100}%` }} />
          </span>
          {busy.cancel && <Button label={t('ui.cancel')} onClick={busy.cancel} />}
        </span>
      )}
      <span class="status-figures">
        {parts.map((part) => (
          <span key={part}>{part}</span>
        ))}
      </span>
    </footer>
  );
}

const deformParts = (figures: Figures) => [
  figures.vertices !== null && t('ui.figure.vertices', { count: figures.vertices }),
  figures.free !== null && t('ui.figure.free', { count: figures.free }),
  figures.factor !== null && t('ui.figure.factor', { ms: Math.round(figures.factor) }),
  figures.solve !== null && t('ui.figure.solve', { ms: milliseconds(figures.solve) }),
  figures.drag !== null && t('ui.figure.drag', { ms: Math.round(figures.drag) }),
];

const hairParts = (figures: HairFigures) => [
  t('ui.hair.figure.strands', { count: figures.strands }),
  t('ui.hair.figure.constraints', { count: figures.constraints }),
  t('ui.hair.figure.grid', { size: figures.grid.join(' × ') }),
  t('ui.hair.figure.update', { ms: milliseconds(figures.update) }),
  t('ui.hair.figure.field', { ms: milliseconds(figures.field) }),
  t('ui.hair.figure.grow', { ms: milliseconds(figures.grow) }),
  figures.stroke !== null && t('ui.hair.figure.stroke', { ms: Math.round(figures.stroke) }),
];

const milliseconds = (ms: number): string =>
  ms < 10 ? formatNumber(Number(ms.toFixed(1))) : `${Math.round(ms)}`;
