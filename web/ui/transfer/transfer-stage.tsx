import { t, tCode } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Icon } from '../controls/icon';
import { ModelChooser } from '../shell/model-chooser';
import { Pane } from '../shell/panes';
import { NumberOverlay } from './number-overlay';
import { useTransfer } from './use-transfer';

/** The model that has the pose, to the left of the one that gets it. */
export function TransferStage() {
  const { state, panes } = useApp();
  const { state: own } = useTransfer();
  const source = own.source.value;
  const choosing = state.choosing.value !== null;
  return (
    <>
      <Pane index={0} class="beside">
        {source && !choosing && (
          <NumberOverlay
            view={panes.all.value[0]?.viewport}
            positions={own.atRest.value ? source.rest.model.positions : source.posed}
            rest={source.rest.model.positions}
            sets={source.handles.map(({ vertices }) => vertices)}
          />
        )}
        {source && (
          <p class="pane-label">
            <span class="muted">{t('ui.transfer.source')}</span> {source.rest.model.name}
            {own.atRest.value && !choosing && <span class="muted">{t('ui.transfer.rest')}</span>}
          </p>
        )}
      </Pane>
      <div class="pane over-main">{choosing ? <TargetChooser /> : <Target />}</div>
    </>
  );
}

function TargetChooser() {
  const { actions: transfer } = useTransfer();
  return (
    <ModelChooser
      title={t('ui.transfer.choose')}
      help={t('ui.transfer.choose.help')}
      onCancel={() => transfer.target.cancel()}
    />
  );
}

/** Over the main viewport. */
function Target() {
  const { state, viewport } = useApp();
  const { state: own } = useTransfer();
  const positions = own.positions.value;
  const rest = state.model.value?.positions;
  const sets = own.step.value?.handles;
  return (
    <>
      {positions && rest && sets && (
        <NumberOverlay view={viewport} positions={positions} rest={rest} sets={sets} />
      )}
      <TargetLabels />
    </>
  );
}

/** What is on screen, what there is to say of it, and what to do next. */
function TargetLabels() {
  const { state } = useApp();
  const { state: own, actions: transfer } = useTransfer();
  const name = state.facts.value?.name;
  const problem = own.problem.value;
  return (
    <>
      <div class="main-labels">
        {name !== undefined && (
          <p class="pane-label">
            <span class="muted">{t('ui.transfer.target')}</span> {name}
            {own.atRest.value && <span class="muted">{t('ui.transfer.rest')}</span>}
          </p>
        )}
        {problem && (
          <p class="pane-label warn" role="alert">
            <Icon name="triangle-alert" />
            {problem}
          </p>
        )}
        {problem && transfer.pose() && (
          <Button kind="solid" label={t('ui.transfer.fit')} onClick={() => transfer.fitHandles()} />
        )}
        {state.warnings.value.map(({ code, count }) => (
          <p key={code} class="pane-label warn">
            <Icon name="triangle-alert" />
            {tCode('finding.', code, 'finding.unknown', { count })}
          </p>
        ))}
      </div>
      <Hint />
    </>
  );
}

/** The next thing to do while pairs are missing. */
function Hint() {
  const { state } = useApp();
  const { state: own, actions: transfer } = useTransfer();
  const pose = transfer.pose();
  const open = transfer.open();
  if (!pose || own.problem.value || own.atRest.value || open.length === 0) return null;
  const { item } = state.selection.value;
  const handle = item === null ? undefined : pose.handles[item];
  if (!handle) return <p class="hint">{t('ui.transfer.hint.pick')}</p>;
  if (item !== null && open.includes(item)) {
    const name = transfer.handleName(item, pose);
    return (
      <p class="hint">
        {t(handle.kind === 'point' ? 'ui.transfer.hint.point' : 'ui.transfer.hint.paint', { name })}
      </p>
    );
  }
  return pose.handles.length - open.length === 1 ? <p class="hint">{t('ui.transfer.hint.more')}</p> : null;
}
