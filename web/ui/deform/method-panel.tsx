import { t } from '../../app/i18n';

import { Segments, SelectField, SliderField, Switch } from '../controls/fields';
import { Section } from '../controls/section';
import { IsolineOptions } from './isoline-options';
import { useDeform } from './use-deform';

export function MethodPanel() {
  const { state: own, actions: deform } = useDeform();
  const step = own.step.value;
  if (!step) return null;
  const { method, options } = step;
  return (
    <Section title={t('ui.method')}>
      <SelectField
        label={t('ui.method.name')}
        value={method}
        options={(['implicit', 'iterative', 'isolines', 'naive'] as const).map((value) => ({
          value,
          label: t(`ui.method.${value}`),
        }))}
        onChange={(value) => deform.setMethod(value)}
      />
      {method === 'isolines' && <IsolineOptions />}
      {(method === 'implicit' || method === 'iterative') && (
        <>
          {method === 'implicit' && (
            <Switch
              label={t('ui.method.shear')}
              title={t('ui.method.shear.help')}
              checked={options.removeShear}
              onChange={(removeShear) => deform.setOptions({ removeShear })}
            />
          )}
          <Switch
            label={t('ui.method.scale')}
            title={t('ui.method.scale.help')}
            checked={options.scaleDetails}
            disabled={method === 'implicit' && !options.removeShear}
            onChange={(scaleDetails) => deform.setOptions({ scaleDetails })}
          />
          <div class="field">
            <span class="label" title={t('ui.method.ring.help')}>
              {t('ui.method.ring')}
            </span>
            <Segments
              label={t('ui.method.ring')}
              value={String(options.coherenceRing)}
              options={['1', '2'].map((value) => ({ value, label: value }))}
              onChange={(ring) => deform.setOptions({ coherenceRing: ring === '2' ? 2 : 1 })}
            />
          </div>
        </>
      )}
      {method === 'iterative' && (
        <SliderField
          label={t('ui.method.iterations')}
          value={options.iterations}
          min={1}
          max={20}
          step={1}
          digits={0}
          onChange={(iterations) => deform.setOptions({ iterations: Math.round(iterations) })}
        />
      )}
    </Section>
  );
}
