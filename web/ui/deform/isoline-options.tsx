import { t } from '../../app/i18n';
import { SelectField, SliderField, Switch } from '../controls/fields';
import { useDeform } from './use-deform';

/** What the isoline method can be told; where the recipe says nothing, the kernel's own figures. */
const USUAL = { isolines: 10, basis: 'quadratic', local: 'patches', settle: 'full' } as const;

export function IsolineOptions() {
  const { state: own, actions: deform } = useDeform();
  const step = own.step.value;
  if (!step) return null;
  const { options } = step;
  return (
    <>
      <SliderField
        label={t('ui.isolines.count')}
        value={options.isolines ?? USUAL.isolines}
        min={3}
        max={40}
        step={1}
        digits={0}
        onChange={(count) => deform.setOptions({ isolines: Math.round(count) })}
      />
      <SelectField
        label={t('ui.isolines.basis')}
        value={options.basis ?? USUAL.basis}
        options={(['quadratic', 'hats'] as const).map((value) => ({
          value,
          label: t(`ui.isolines.${value}`),
        }))}
        onChange={(basis) => deform.setOptions({ basis })}
      />
      <SelectField
        label={t('ui.isolines.local')}
        value={options.local ?? USUAL.local}
        options={(['patches', 'isolines', 'positions'] as const).map((value) => ({
          value,
          label: t(`ui.isolines.local.${value}`),
        }))}
        onChange={(local) => deform.setOptions({ local })}
      />
      <Switch
        label={t('ui.isolines.full')}
        title={t('ui.isolines.full.help')}
        checked={(options.settle ?? USUAL.settle) === 'full'}
        onChange={(full) => deform.setOptions({ settle: full ? 'full' : 'reduced' })}
      />
      <Switch
        label={t('ui.method.scale')}
        title={t('ui.method.scale.help')}
        checked={options.scaleDetails}
        onChange={(scaleDetails) => deform.setOptions({ scaleDetails })}
      />
      <SelectField
        label={t('ui.isolines.show')}
        value={own.isolines.value}
        options={(['nothing', 'lines', 'field', 'rigidity'] as const).map((value) => ({
          value,
          label: t(`ui.isolines.show.${value}`),
        }))}
        onChange={(shown) => {
          own.isolines.value = shown;
        }}
      />
    </>
  );
}
