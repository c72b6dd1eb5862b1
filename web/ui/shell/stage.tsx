import { useLayoutEffect, useRef } from 'preact/hooks';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { HeatLegend } from '../deform/heat-legend';
import { ViewedBar } from '../hair/viewed-bar';
import { ViewBar } from './view-bar';

/** Holds the viewport's canvas, which lives longer than any component, and what floats over it. */
export function Stage({ canvas }: { canvas: HTMLElement }) {
  const { state, viewport } = useApp();
  const frame = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    frame.current?.prepend(canvas);
  }, [canvas]);
  const hint = state.hint.value;
  return (
    <main ref={frame} class="stage" aria-label={t('ui.viewport')}>
      {viewport === null && <p class="stage-empty">{t('ui.no-webgl')}</p>}
      <ViewBar />
      <ViewedBar />
      {hint && !state.hair.viewed.value && <p class="hint">{t(hint)}</p>}
      {state.heat.value && <HeatLegend />}
      {state.dropping.value && (
        <div class="drop">
          <p>{t('ui.drop')}</p>
        </div>
      )}
    </main>
  );
}
