import { t } from '../../app/i18n';
import type { Figures } from '../../app/state';
import { useApp, useFace } from '../context';
import { Button } from '../controls/button';
import { FigureList, milliseconds } from '../controls/figure-list';

/** What a click and a drag do now; what the kernel is at; its figures. */
export function StatusBar() {
  const { state } = useApp();
  const figures = state.figures.value;
  const busy = state.busy.value;
  const Own = useFace()?.Figures;
  const fps =
    state.previewing.value && figures.fps >= 2 && t('ui.figure.fps', { count: Math.round(figures.fps) });
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
        {/* Leftmost, so that its coming and going moves nothing else. */}
        <FigureList parts={[fps]} />
        {Own ? <Own /> : <FigureList parts={kernelParts(figures)} />}
      </span>
    </footer>
  );
}

const kernelParts = (figures: Figures) => [
  figures.vertices !== null && t('ui.figure.vertices', { count: figures.vertices }),
  figures.free !== null && t('ui.figure.free', { count: figures.free }),
  figures.factor !== null && t('ui.figure.factor', { ms: Math.round(figures.factor) }),
  figures.solve !== null && t('ui.figure.solve', { ms: milliseconds(figures.solve) }),
  figures.drag !== null && t('ui.figure.drag', { ms: Math.round(figures.drag) }),
];
