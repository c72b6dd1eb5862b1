import { t } from '../../app/i18n';
import { pointsOf } from '../../recipe/steps/curves-edits';
import { NumberField, SliderField, VectorField } from '../controls/fields';
import { Section } from '../controls/section';
import { useCurves } from './use-curves';

const WIDTHS = [
  { label: 'ui.curves.point.scale.wide', axis: 'X' },
  { label: 'ui.curves.point.scale.deep', axis: 'Y' },
] as const;

/** The selected control point in numbers. */
export function PointPanel() {
  const { state: own, actions: curves } = useCurves();
  const grip = own.grip.value;
  const curve = curves.curve();
  if (!curve || grip?.point == null) return null;
  const { point } = grip;
  const widths = curve.scale?.[point] ?? [1, 1];
  const done = () => curves.edits.finish();
  return (
    <Section title={t('ui.curves.point', { number: point + 1 })}>
      <VectorField
        label={t('ui.curves.point.place')}
        value={pointsOf(curve)[point]!}
        step={0.01}
        onChange={(to) => curves.setPoint(grip, to)}
        onCommit={done}
      />
      <SliderField
        label={t('ui.curves.point.twist')}
        value={curve.twist?.[point] ?? 0}
        min={-360}
        max={360}
        step={1}
        digits={1}
        onChange={(degrees) => curves.setTwist(grip, degrees)}
        onCommit={done}
      />
      <div class="field">
        <span class="label">{t('ui.curves.point.scale')}</span>
        <span class="vector">
          {WIDTHS.map(({ label, axis }, side) => (
            <NumberField
              key={axis}
              label={t(label)}
              axis={axis}
              value={widths[side]!}
              min={0.05}
              max={20}
              step={0.05}
              onChange={(x) => curves.setScale(grip, side === 0 ? [x, widths[1]] : [widths[0], x])}
              onCommit={done}
            />
          ))}
        </span>
      </div>
      <SliderField
        label={t('ui.curves.point.range')}
        value={own.range.value}
        min={0}
        max={8}
        step={1}
        digits={0}
        onChange={(range) => {
          own.range.value = Math.round(range);
        }}
      />
    </Section>
  );
}
