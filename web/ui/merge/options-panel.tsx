import { t } from '../../app/i18n';
import type { MergeStep } from '../../recipe/recipe';
import { useApp } from '../context';
import { Segments, SliderField, Switch, VectorField } from '../controls/fields';
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
      {step.boundaries.length > 0 && <Mode mode={step.mode} />}
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

/** Fitted or in place. */
function Mode({ mode }: { mode: MergeStep['mode'] }) {
  const { merge } = useApp();
  return (
    <>
      <div class="field">
        <span class="label">{t('ui.merge.mode')}</span>
        <Segments
          label={t('ui.merge.mode')}
          value={mode}
          options={(['independent', 'dependent'] as const).map((value) => ({
            value,
            label: t(`ui.merge.mode.${value}`),
          }))}
          onChange={(next) => merge.setMode(next)}
        />
      </div>
      <p class="muted">{t(`ui.merge.mode.${mode}.help`)}</p>
      {mode === 'dependent' && <PoseFields />}
    </>
  );
}

/** Where the part stands, as numbers, and how much of it gives way. */
function PoseFields() {
  const { merge } = useApp();
  const { translation, rotation, scale } = merge.pose();
  const finish = () => merge.finish();
  return (
    <>
      <VectorField
        label={t('ui.pose.move')}
        value={translation}
        step={0.01}
        digits={3}
        onChange={(value) => merge.setPose({ translation: value }, true)}
        onCommit={finish}
      />
      <VectorField
        label={t('ui.pose.turn')}
        title={t('ui.pose.turn.help')}
        value={rotation}
        step={1}
        digits={1}
        onChange={(value) => merge.setPose({ rotation: value }, true)}
        onCommit={finish}
      />
      <VectorField
        label={t('ui.pose.size')}
        value={scale}
        step={0.01}
        min={0.001}
        digits={3}
        onChange={(value) => merge.setPose({ scale: value }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.merge.reach')}
        value={100 * merge.reach()}
        min={5}
        max={150}
        step={1}
        digits={0}
        onChange={(percent) => merge.setReach(percent / 100, true)}
        onCommit={finish}
      />
    </>
  );
}
