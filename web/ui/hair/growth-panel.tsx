import { t } from '../../app/i18n';
import { useApp } from '../context';

import { CommandButton } from '../controls/command-button';
import { NumberField, SliderField } from '../controls/fields';
import { Section } from '../controls/section';
import { usePercent } from './percent';
import { useHair } from './use-hair';

/** How much hair, how long, how full. */
export function GrowthPanel() {
  const { state } = useApp();
  const { state: own, actions: hair } = useHair();
  const { percent, length } = usePercent();
  const step = own.step.value;
  if (!step) return null;
  const finish = () => hair.finish();
  const { strands, length: lengths, volume, grid } = step;
  return (
    <Section title={t('ui.hair.growth')} aside={<CommandButton command="hair.new-seed" iconOnly />}>
      <div class="field">
        <span class="label">{t('ui.hair.count')}</span>
        <NumberField
          label={t('ui.hair.count')}
          value={strands.count}
          min={0}
          max={1_000_000}
          step={1000}
          digits={0}
          onChange={(count) => hair.update({ strands: { count: Math.round(count) } }, true)}
          onCommit={finish}
        />
      </div>
      <SliderField
        label={t('ui.hair.length')}
        value={percent(lengths.max, 100)}
        min={3}
        max={300}
        step={1}
        digits={0}
        onChange={(value) => hair.update({ length: { max: length(value) } }, true)}
        onCommit={finish}
      />
      <div class="buttons">
        <CommandButton command="tool.paint-length" kind="solid" />
        {lengths.map.length > 0 && <CommandButton command="hair.clear-lengths" kind="solid" />}
      </div>
      {state.tool.value === 'paint-length' && (
        <SliderField
          label={t('ui.hair.length-brush')}
          value={100 * own.lengthBrush.value}
          min={0}
          max={200}
          step={5}
          digits={0}
          onChange={(value) => {
            own.lengthBrush.value = Math.round(value) / 100;
          }}
        />
      )}
      <SliderField
        label={t('ui.hair.variation')}
        value={lengths.variation}
        min={0}
        max={1}
        digits={2}
        onChange={(variation) => hair.update({ length: { variation } }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.volume')}
        value={percent(volume, 3)}
        min={0}
        max={15}
        step={0.1}
        digits={1}
        onChange={(value) => hair.update({ volume: length(value) }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.step')}
        value={strands.step}
        min={0.1}
        max={2}
        step={0.05}
        digits={2}
        onChange={(fineness) => hair.update({ strands: { step: fineness } }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.resolution')}
        value={grid.resolution}
        min={16}
        max={96}
        step={1}
        digits={0}
        onChange={(resolution) => hair.update({ grid: { resolution: Math.round(resolution) } }, true)}
        onCommit={finish}
      />
    </Section>
  );
}
