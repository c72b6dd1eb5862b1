import { t } from '../../app/i18n';
import type { MergeStep } from '../../recipe/recipe';

import { Segments, SliderField, Switch } from '../controls/fields';
import { PoseFields } from '../controls/pose-fields';
import { Section } from '../controls/section';
import { useMerge } from './use-merge';

/** How the two are merged. */
export function OptionsPanel() {
  const { state: own, actions: merge } = useMerge();
  const step = own.step.value;
  if (!step) return null;
  const finish = () => merge.edits.finish();
  const shares = merge.shape.transitionShares();
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
        onChange={(rounds) => merge.shape.setSmoothing(Math.round(rounds), true)}
        onCommit={finish}
      />
      {step.boundaries.length > 0 && (
        <>
          <Switch
            label={t('ui.merge.transition')}
            title={t('ui.merge.transition.help')}
            checked={step.transition !== undefined}
            onChange={(on) => merge.shape.setTransition(on ? shares : null)}
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
                onChange={(percent) => merge.shape.setTransition({ ...shares, [side]: percent / 100 }, true)}
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
  const { actions: merge } = useMerge();
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
          onChange={(next) => merge.shape.setMode(next)}
        />
      </div>
      <p class="muted">{t(`ui.merge.mode.${mode}.help`)}</p>
      {mode === 'dependent' && <Placed />}
    </>
  );
}

/** Where the part stands, as numbers, and how much of it gives way. */
function Placed() {
  const { actions: merge } = useMerge();
  const finish = () => merge.edits.finish();
  return (
    <>
      <PoseFields
        pose={merge.shape.pose()}
        onChange={(change) => merge.shape.setPose(change, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.merge.reach')}
        value={100 * merge.shape.reach()}
        min={5}
        max={150}
        step={1}
        digits={0}
        onChange={(percent) => merge.shape.setReach(percent / 100, true)}
        onCommit={finish}
      />
    </>
  );
}
