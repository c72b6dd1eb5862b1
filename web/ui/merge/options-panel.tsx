import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Segments, SliderField, Switch } from '../controls/fields';
import { Section } from '../controls/section';

/** How the two are merged. */
export function OptionsPanel() {
  const { state, merge } = useApp();
  const step = state.mergeStep.value;
  if (!step) return null;
  const finish = () => merge.finish();
  const shares = merge.transitionShares();
  return (
    <Section title={t('ui.merge.options')}>
      <div class="field">
        <span class="label">{t('ui.merge.mode')}</span>
        <Segments
          label={t('ui.merge.mode')}
          value={step.mode}
          options={(['independent', 'dependent'] as const).map((value) => ({
            value,
            label: t(`ui.merge.mode.${value}`),
          }))}
          onChange={(mode) => merge.setMode(mode)}
        />
      </div>
      <p class="muted">{t(`ui.merge.mode.${step.mode}.help`)}</p>
      <SliderField
        label={t('ui.merge.smoothing')}
        value={step.smoothing}
        min={0}
        max={20}
        step={1}
        digits={0}
        onChange={(rounds) => merge.setSmoothing(Math.round(rounds), true)}
        onCommit={finish}
      />
      {step.boundaries.length > 0 && (
        <>
          <Switch
            label={t('ui.merge.transition')}
            title={t('ui.merge.transition.help')}
            checked={step.transition !== undefined}
            onChange={(on) => merge.setTransition(on ? shares : null)}
          />
          {step.transition &&
            (['source', 'target'] as const).map((side) => (
              <SliderField
                key={side}
                label={t(`ui.merge.transition.${side}`)}
                value={100 * shares[side]}
                min={1}
                max={40}
                step={0.5}
                digits={1}
                onChange={(percent) => merge.setTransition({ ...shares, [side]: percent / 100 }, true)}
                onCommit={finish}
              />
            ))}
        </>
      )}
    </Section>
  );
}
