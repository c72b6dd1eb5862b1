import { shortName } from '../../app/blend/matches';
import { PART_TINTS } from '../../app/blend/view-sync';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { SelectField, SliderField } from '../controls/fields';
import { ItemRow } from '../controls/item-row';
import { Section } from '../controls/section';
import { useBlend } from './use-blend';

/** Of the model's size, how wide a feather may be with the slider. */
const WIDEST = 0.15;
const HOW = ['paste', 'low-pass'] as const;

/** Parts of the shape that one model gives alone. */
export function PartsPanel() {
  const { state, document } = useApp();
  const { state: own, actions: blend } = useBlend();
  const step = own.step.value;
  if (!step) return null;
  const { item } = state.selection.value;
  return (
    <Section
      title={t('ui.blend.parts')}
      closed={step.parts.length === 0 && step.measures.length > 0}
      aside={<CommandButton command="blend.new-part" iconOnly />}
    >
      {step.parts.length === 0 && <p class="muted">{t('ui.blend.parts.none')}</p>}
      <ul class="list" aria-label={t('ui.blend.parts')}>
        {step.parts.map((part, index) => (
          <ItemRow
            key={index}
            name={blend.partName(index, part)}
            icon="highlighter"
            selected={index === item}
            onSelect={() => document.select(index === item ? null : index)}
            onRename={(name) => blend.changePart(index, { name })}
            onRemove={() => blend.removePart(index)}
          >
            <span class={`dot part-${PART_TINTS[index % PART_TINTS.length]}`} />
            <span class="muted count">{shortName(part.from)}</span>
          </ItemRow>
        ))}
      </ul>
      {item !== null && step.parts[item] ? <Selected index={item} /> : <Next />}
    </Section>
  );
}

function Selected({ index }: { index: number }) {
  const { state: own, actions: blend } = useBlend();
  const part = own.step.value!.parts[index]!;
  const { from, how } = part;
  const feather = blend.featherOf(part);
  const widest = Math.max(WIDEST * blend.size(), feather);
  return (
    <>
      <SelectField
        label={t('ui.blend.part.from')}
        value={from}
        options={blend.names().map((name) => ({ value: name, label: shortName(name) }))}
        onChange={(name) => blend.changePart(index, { from: name })}
      />
      <SliderField
        label={t(part.feather === undefined ? 'ui.blend.part.feather.usual' : 'ui.blend.part.feather')}
        value={feather}
        min={0}
        max={widest}
        step={Number((widest / 100).toPrecision(1))}
        onChange={(width) => blend.changePart(index, { feather: width }, true)}
        onCommit={() => blend.edits.finish()}
      />
      {part.feather !== undefined && (
        <div class="buttons">
          <Button
            icon="rotate-ccw"
            label={t('ui.blend.part.feather.reset')}
            onClick={() => blend.resetFeather(index)}
          />
        </div>
      )}
      <SelectField
        label={t('ui.blend.part.how')}
        value={how}
        options={HOW.map((value) => ({ value, label: t(`ui.blend.part.${value}`) }))}
        onChange={(value) => blend.changePart(index, { how: value })}
      />
    </>
  );
}

/** Whose shape the part has that is painted next. */
function Next() {
  const { state } = useApp();
  const { state: own, actions: blend } = useBlend();
  if (state.tool.value !== 'paint-part') return null;
  return (
    <SelectField
      label={t('ui.blend.parts.next')}
      value={blend.nextFrom()}
      options={blend.names().map((name) => ({ value: name, label: shortName(name) }))}
      onChange={(name) => {
        own.nextFrom.value = name;
      }}
    />
  );
}
