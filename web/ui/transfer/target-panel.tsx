import { t } from '../../app/i18n';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { useTransfer } from './use-transfer';

/** The model that gets the pose. */
export function TargetPanel() {
  const facts = useApp().state.facts.value;
  const name = useTransfer().state.step.value?.model;
  if (!facts || name === undefined) return null;
  return (
    <Section title={t('ui.transfer.model')} aside={<CommandButton command="transfer.target" iconOnly />}>
      <p class="model-name">{name}</p>
      <p class="muted">{t('ui.model.counts', { vertices: facts.vertices, faces: facts.faces })}</p>
    </Section>
  );
}
