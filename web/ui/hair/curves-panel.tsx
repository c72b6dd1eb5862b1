import { t } from '../../app/i18n';
import { type Primitive, type PrimitiveKind, primitivesOf } from '../../tools/hair/style';
import { useApp } from '../context';

import { CommandButton } from '../controls/command-button';
import { SliderField, Switch } from '../controls/fields';
import { ItemRow } from '../controls/item-row';
import { Section } from '../controls/section';
import { useHair } from './use-hair';

const ICONS: Readonly<Record<PrimitiveKind, string>> = {
  stream: 'spline',
  parting: 'split',
  ponytail: 'ribbon',
};

/** What is drawn: a line each, and the options of the selected one. */
export function CurvesPanel() {
  const { state } = useApp();
  const { state: own } = useHair();
  const step = own.step.value;
  if (!step) return null;
  const primitives = primitivesOf(step);
  const selected = state.selection.value.item;
  return (
    <Section
      title={t('ui.hair.curves')}
      aside={
        <>
          <CommandButton command="brush.mirror" iconOnly />
          <CommandButton command="hair.duplicate" iconOnly />
        </>
      }
    >
      {primitives.length === 0 && <p class="muted">{t('ui.hair.curves.none')}</p>}
      <ul class="list" aria-label={t('ui.hair.curves')}>
        {primitives.map((primitive, index) => (
          <CurveRow key={index} index={index} primitive={primitive} />
        ))}
      </ul>
      {selected !== null && primitives[selected] && (
        <Options index={selected} primitive={primitives[selected]} />
      )}
    </Section>
  );
}

function CurveRow({ index, primitive }: { index: number; primitive: Primitive }) {
  const { state } = useApp();
  const { actions: hair } = useHair();
  const selected = state.selection.value.item === index;
  return (
    <ItemRow
      name={hair.primitiveName(index)}
      icon={ICONS[primitive.kind]}
      selected={selected}
      hidden={primitive.item.hidden === true}
      onSelect={() => hair.select(selected ? null : index)}
      onRename={(name) => hair.rename(index, name)}
      onHide={(hidden) => hair.hide(index, hidden)}
      onRemove={() => hair.remove(index)}
    />
  );
}

function Options({ index, primitive }: { index: number; primitive: Primitive }) {
  const { actions: hair } = useHair();
  const finish = () => hair.finish();
  if (primitive.kind === 'stream')
    return (
      <Switch
        label={t('ui.hair.stream.fade')}
        title={t('ui.hair.stream.fade.help')}
        checked={primitive.item.fade}
        onChange={(fade) => hair.setPrimitive(index, { fade })}
      />
    );
  if (primitive.kind === 'ponytail')
    return (
      <>
        {primitive.item.section.length === 0 && <p class="muted">{t('ui.hair.ponytail.unfinished')}</p>}
        <SliderField
          label={t('ui.hair.ponytail.tightness')}
          value={primitive.item.tightness}
          min={0}
          max={1}
          digits={2}
          onChange={(tightness) => hair.setPrimitive(index, { tightness }, true)}
          onCommit={finish}
        />
      </>
    );
  const { tilt, sigma, height } = primitive.item;
  const [first, last] = tilt;
  return (
    <>
      <SliderField
        label={t('ui.hair.parting.tilt-start')}
        value={first}
        min={-75}
        max={75}
        step={1}
        digits={0}
        onChange={(a) => hair.setPrimitive(index, { tilt: [a, last] }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.parting.tilt-end')}
        value={last}
        min={-75}
        max={75}
        step={1}
        digits={0}
        onChange={(b) => hair.setPrimitive(index, { tilt: [first, b] }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.parting.sigma')}
        value={sigma}
        min={0.2}
        max={4}
        step={0.05}
        digits={2}
        onChange={(s) => hair.setPrimitive(index, { sigma: s }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.parting.height')}
        value={height}
        min={0}
        max={3}
        step={0.05}
        digits={2}
        onChange={(h) => hair.setPrimitive(index, { height: h }, true)}
        onCommit={finish}
      />
    </>
  );
}
