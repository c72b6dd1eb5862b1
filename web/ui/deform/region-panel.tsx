import { t } from '../../app/i18n';
import { useApp } from '../context';

import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { useDeform } from './use-deform';

export function RegionPanel() {
  const { state } = useApp();
  const { state: own } = useDeform();
  const step = own.step.value;
  if (!step) return null;
  const free = state.figures.value.free;
  return (
    <Section title={t('ui.region')} aside={<span class="dot roi" />}>
      <p class="muted">
        {step.roi === 'all' ? t('ui.region.all') : t('ui.region.painted')}
        {free !== null && ` · ${t('ui.region.free', { count: free })}`}
      </p>
      <div class="buttons">
        <CommandButton command="tool.paint-roi" kind="solid" short={t('ui.region.paint')} />
        <CommandButton command="roi.everything" kind="solid" short={t('ui.region.everything')} />
        <CommandButton command="roi.clear" kind="solid" short={t('ui.region.clear')} />
      </div>
    </Section>
  );
}
