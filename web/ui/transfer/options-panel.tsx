import { t } from '../../app/i18n';
import { MAX_STRENGTH } from '../../recipe/steps/transfer';
import { SliderField, Switch } from '../controls/fields';
import { Section } from '../controls/section';
import { useTransfer } from './use-transfer';

/** How much of the pose is given, and what becomes of stretch. */
export function OptionsPanel() {
  const { state: own, actions: transfer } = useTransfer();
  const step = own.step.value;
  if (!step) return null;
  return (
    <Section title={t('ui.transfer.options')}>
      <SliderField
        label={t('ui.transfer.strength')}
        value={100 * step.strength}
        min={0}
        max={100 * MAX_STRENGTH}
        step={1}
        digits={0}
        onChange={(percent) => transfer.setStrength(percent / 100, true)}
        onCommit={() => transfer.edits.finish()}
      />
      <Switch
        label={t('ui.transfer.stretch')}
        title={t('ui.transfer.stretch.help')}
        checked={step.keepStretch}
        onChange={(on) => transfer.setKeepStretch(on)}
      />
    </Section>
  );
}
