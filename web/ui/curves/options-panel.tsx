import { t } from '../../app/i18n';
import { SelectField } from '../controls/fields';
import { Section } from '../controls/section';
import { useCurves } from './use-curves';

/** How the curves bend the model: rarely to be changed. */
export function OptionsPanel() {
  const { state: own, actions: curves } = useCurves();
  const step = own.step.value;
  if (!step) return null;
  const { blending, guard, encoding } = step.options;
  return (
    <Section title={t('ui.curves.options')} closed>
      <SelectField
        label={t('ui.curves.blending')}
        value={blending}
        options={(['ownership', 'geodesic', 'gaussian'] as const).map((value) => ({
          value,
          label: t(`ui.curves.blending.${value}`),
        }))}
        onChange={(value) => curves.setOptions({ blending: value })}
      />
      <SelectField
        label={t('ui.curves.guard')}
        value={guard}
        options={(['symmetric', 'thesis', 'none'] as const).map((value) => ({
          value,
          label: t(`ui.curves.guard.${value}`),
        }))}
        onChange={(value) => curves.setOptions({ guard: value })}
      />
      <SelectField
        label={t('ui.curves.encoding')}
        value={encoding}
        options={(['kernel', 'slabs'] as const).map((value) => ({
          value,
          label: t(`ui.curves.encoding.${value}`),
        }))}
        onChange={(value) => curves.setOptions({ encoding: value })}
      />
    </Section>
  );
}
