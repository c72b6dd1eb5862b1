import { useLayoutEffect, useRef } from 'preact/hooks';
import { t } from '../../app/i18n';
import type { State } from '../../app/state';
import type { MergeSide } from '../../tools/merge/pins';
import { useApp } from '../context';
import { Icon } from '../controls/icon';
import type { Frames } from '../shell/stage';
import { PartChooser } from './part-chooser';
import { PinOverlay } from './pin-overlay';

/** The two models side by side over the merged one, with the pins that tie them together. */
export function MergeStage({ frames }: { frames: Frames }) {
  const { state } = useApp();
  const choosing = state.choosing.value;
  return (
    <>
      <Pane side="source" frame={frames.source}>
        {choosing && <PartChooser />}
      </Pane>
      <Pane side="target" frame={frames.target} />
      {!choosing && <PinOverlay />}
      <ResultLabel />
    </>
  );
}

interface PaneProps {
  side: MergeSide;
  frame: HTMLElement;
  children?: preact.ComponentChildren;
}

function Pane({ side, frame, children }: PaneProps) {
  const holder = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    holder.current?.prepend(frame);
  }, [frame]);
  const { state, merge } = useApp();
  const model = state.merge.sides.value[side]?.model;
  const step = state.mergeStep.value;
  const isBlank =
    !state.choosing.value &&
    step?.boundaries.length === 0 &&
    merge.markSize(side) === 0 &&
    !isPainted(state, side);
  return (
    <div ref={holder} class={`pane ${side}`}>
      {model && (
        <p class="pane-label">
          <span class={`dot ${side}`} />
          <span class="muted">{t(`ui.merge.${side}`)}</span> {model.name}
        </p>
      )}
      {isBlank && state.tool.value !== 'merge-pins' && <p class="hint">{t(`ui.merge.hint.${side}`)}</p>}
      {children}
    </div>
  );
}

const isPainted = ({ merge }: State, side: MergeSide): boolean => merge.paint.value?.mark === side;

/** What the lower view shows, or what is still missing for it. */
function ResultLabel() {
  const { state } = useApp();
  const merged = state.merge.figures.value !== null && !state.choosing.value;
  const before = state.merge.before.value && state.mergeStep.value?.optimalBoundary;
  const problem = state.merge.problem.value;
  return (
    <div class="result-label">
      <p class="pane-label">
        {merged ? t(before ? 'ui.merge.result.before' : 'ui.merge.result') : t('ui.merge.result.none')}
      </p>
      {problem && (
        <p class="pane-label warn" role="alert">
          <Icon name="triangle-alert" />
          {problem}
        </p>
      )}
    </div>
  );
}
