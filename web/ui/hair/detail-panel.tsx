import { t } from '../../app/i18n';

import { SliderField } from '../controls/fields';
import { Section } from '../controls/section';
import { usePercent } from './percent';
import { useHair } from './use-hair';

const SHARES = ['clump', 'curl', 'frizz', 'flyaways'] as const;

/** What keeps hair from looking combed by a machine. */
export function DetailPanel() {
  const { state: own, actions: hair } = useHair();
  const { percent, length } = usePercent();
  const step = own.step.value;
  if (!step) return null;
  const { detail } = step;
  const finish = () => hair.finish();
  return (
    <Section title={t('ui.hair.detail')}>
      {SHARES.map((field) => (
        <SliderField
          key={field}
          label={t(`ui.hair.${field}`)}
          value={detail[field]}
          min={0}
          max={1}
          digits={2}
          onChange={(value) => hair.update({ detail: { [field]: value } }, true)}
          onCommit={finish}
        />
      ))}
      {detail.curl > 0 && (
        <SliderField
          label={t('ui.hair.curl-length')}
          value={percent(detail.curlLength, 16)}
          min={2}
          max={60}
          step={0.5}
          digits={1}
          onChange={(value) => hair.update({ detail: { curlLength: length(value) } }, true)}
          onCommit={finish}
        />
      )}
    </Section>
  );
}
