import { useLayoutEffect, useRef } from 'preact/hooks';
import { t } from '../../app/i18n';
import type { MergeSide } from '../../tools/merge/pins';
import { useApp } from '../context';
import { HeatLegend } from '../deform/heat-legend';
import { LengthLegend } from '../hair/length-legend';
import { ViewedBar } from '../hair/viewed-bar';
import { MergeStage } from '../merge/merge-stage';
import { ViewBar } from './view-bar';

/** The viewports' elements, which live longer than any component: the main one, and those of two models to merge. */
export type Frames = Readonly<Record<'main' | MergeSide, HTMLElement>>;

/** Holds the main viewport's canvas and what floats over it; beside it the two models where they are merged. */
export function Stage({ frames }: { frames: Frames }) {
  const { state, viewport } = useApp();
  const frame = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    frame.current?.prepend(frames.main);
  }, [frames]);
  const hint = state.hint.value;
  const merging = state.workspace.value === 'merge';
  return (
    <main ref={frame} class={merging ? 'stage merging' : 'stage'} aria-label={t('ui.viewport')}>
      {merging && <MergeStage frames={frames} />}
      {viewport === null && <p class="stage-empty">{t('ui.no-webgl')}</p>}
      <ViewBar />
      <ViewedBar />
      {hint && !merging && !state.hair.viewed.value && <p class="hint">{t(hint)}</p>}
      {state.tool.value === 'paint-length' ? (
        <LengthLegend />
      ) : (
        state.heat.value && !merging && <HeatLegend />
      )}
      {state.dropping.value && (
        <div class="drop">
          <p>{t(state.choosing.value ? 'ui.drop.part' : 'ui.drop')}</p>
        </div>
      )}
    </main>
  );
}
