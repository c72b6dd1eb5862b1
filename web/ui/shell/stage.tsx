import { useLayoutEffect, useRef } from 'preact/hooks';
import { t } from '../../app/i18n';
import { useApp, useFace } from '../context';
import { ViewBar } from './view-bar';
import { ViewedBar } from './viewed-bar';

/**
 * Holds the main viewport's canvas and what floats over it; beside it the open wing's own stage.
 * @param frame  the viewport's element, which lives longer than any component
 */
export function Stage({ frame }: { frame: HTMLElement }) {
  const { state, viewport } = useApp();
  const { Stage: Own, stageClass = '', Legend } = useFace() ?? {};
  const holder = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    holder.current?.prepend(frame);
  }, [frame]);
  const hint = state.hint.value;
  return (
    <main ref={holder} class={`stage ${stageClass}`} aria-label={t('ui.viewport')}>
      {Own && <Own />}
      {viewport === null && <p class="stage-empty">{t('ui.no-webgl')}</p>}
      <ViewBar />
      <ViewedBar />
      {hint && !Own && !state.viewing.value && <p class="hint">{t(hint)}</p>}
      {Legend && <Legend />}
      {state.dropping.value && (
        <div class="drop">
          <p>{t(state.choosing.value?.drop ?? 'ui.drop')}</p>
        </div>
      )}
    </main>
  );
}
