import { t } from '../../app/i18n';
import { SIDES } from '../../app/merge/view-sync';
import type { MergeSide } from '../../tools/merge/pins';
import { useApp } from '../context';
import { Icon } from '../controls/icon';
import { ModelChooser } from '../shell/model-chooser';
import { Pane } from '../shell/panes';
import { PinOverlay } from './pin-overlay';
import { useMerge } from './use-merge';

/** The two models side by side over the merged one, with the pins that tie them together. */
export function MergeStage() {
  const { state } = useApp();
  const choosing = state.choosing.value !== null;
  return (
    <>
      {SIDES.map((side, index) => (
        <Pane key={side} index={index} class={side}>
          <Side side={side} />
          {choosing && side === 'source' && <PartChooser />}
        </Pane>
      ))}
      {!choosing && <PinOverlay />}
      <ResultLabel />
    </>
  );
}

function PartChooser() {
  const { actions: merge } = useMerge();
  return (
    <ModelChooser
      title={t('ui.merge.choose')}
      help={t('ui.merge.choose.help')}
      onCancel={() => merge.part.cancel()}
    />
  );
}

function Side({ side }: { side: MergeSide }) {
  const { state } = useApp();
  const { state: own, actions: merge } = useMerge();
  const model = own.sides.value[side]?.model;
  const isBlank =
    !state.choosing.value &&
    own.step.value?.boundaries.length === 0 &&
    merge.marking.markSize(side) === 0 &&
    own.paint.value?.mark !== side;
  return (
    <>
      {model && (
        <p class="pane-label">
          <span class={`dot ${side}`} />
          <span class="muted">{t(`ui.merge.${side}`)}</span> {model.name}
        </p>
      )}
      {isBlank && state.tool.value !== 'merge-pins' && <p class="hint">{t(`ui.merge.hint.${side}`)}</p>}
    </>
  );
}

/** What the lower view shows, or what is still missing for it. */
function ResultLabel() {
  const { state } = useApp();
  const { state: own } = useMerge();
  const merged = own.figures.value !== null && !state.choosing.value;
  const before = own.before.value && own.step.value?.optimalBoundary;
  const problem = own.problem.value;
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
