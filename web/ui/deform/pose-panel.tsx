import { t } from '../../app/i18n';
import { useApp } from '../context';
import { VectorField } from '../controls/fields';
import { Section } from '../controls/section';

/** The selected handle's move, turn and size as numbers. */
export function PosePanel() {
  const { state, deform } = useApp();
  const index = state.selection.value.handle;
  const handle = index === null ? undefined : state.step.value?.handles[index];
  const pose = index === null ? undefined : deform.pose(index);
  if (index === null || !handle || !pose) return null;
  const finish = () => deform.finish();
  return (
    <Section title={deform.handleName(index)}>
      <VectorField
        label={t('ui.pose.move')}
        value={pose.translation}
        step={0.01}
        digits={3}
        onChange={(translation) => deform.setPose(index, { translation }, true)}
        onCommit={finish}
      />
      {handle.kind === 'region' && (
        <>
          <VectorField
            label={t('ui.pose.turn')}
            title={t('ui.pose.turn.help')}
            value={pose.rotation}
            step={1}
            digits={1}
            onChange={(rotation) => deform.setPose(index, { rotation }, true)}
            onCommit={finish}
          />
          <VectorField
            label={t('ui.pose.size')}
            value={pose.scale}
            step={0.01}
            min={0.001}
            digits={3}
            onChange={(scale) => deform.setPose(index, { scale }, true)}
            onCommit={finish}
          />
        </>
      )}
    </Section>
  );
}
