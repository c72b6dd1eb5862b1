import { t } from '../../app/i18n';
import { mainInput } from '../../recipe/references';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';
import { useTransfer } from './use-transfer';

/** The poses there are; one of them is given. */
export function PosePanel() {
  const { state } = useApp();
  const { state: own, actions: transfer } = useTransfer();
  const choosing = state.choosing.value !== null;
  const poses = transfer.poses();
  const given = choosing ? own.source.value?.id : own.step.value?.like;
  return (
    <Section
      title={t('ui.transfer.pose')}
      aside={
        !choosing && (
          <>
            <CommandButton command="transfer.new-pose" iconOnly />
            <CommandButton command="transfer.edit-pose" iconOnly />
          </>
        )
      }
    >
      {poses.length === 0 && <p class="muted">{t('ui.transfer.pose.none')}</p>}
      <ul class="list" aria-label={t('ui.transfer.pose')}>
        {poses.map((pose) => (
          <li key={pose.id} class={pose.id === given ? 'row selected' : 'row'}>
            <button
              type="button"
              class="row-main"
              aria-pressed={pose.id === given}
              disabled={choosing}
              onClick={() => transfer.choosePose(pose.id)}
            >
              <Icon name="person-standing" />
              <span>{pose.id}</span>
              <span class="muted count">{mainInput(pose)}</span>
            </button>
          </li>
        ))}
      </ul>
    </Section>
  );
}
