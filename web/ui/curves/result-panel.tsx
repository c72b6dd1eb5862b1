import { t } from '../../app/i18n';
import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { useCurves } from './use-curves';

/** Whether the surface goes through itself. */
export function ResultPanel() {
  const crossings = useCurves().state.figures.value?.crossings;
  if (!crossings) return null;
  const { before, after } = crossings;
  return (
    <Section title={t('ui.curves.result')}>
      <dl class="figures">
        <dt>{t('ui.curves.crossings.before')}</dt>
        <dd>{before}</dd>
        <dt>{t('ui.curves.crossings.after')}</dt>
        <dd class={after <= before ? 'good' : 'bad'}>{after}</dd>
      </dl>
      <div class="buttons">
        <CommandButton command="curves.crossings" kind="solid" />
      </div>
    </Section>
  );
}
