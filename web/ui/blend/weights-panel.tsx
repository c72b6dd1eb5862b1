import type { WeightRow } from '../../app/blend/actions';
import { shortName } from '../../app/blend/matches';
import { t } from '../../app/i18n';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { SliderField, Switch } from '../controls/fields';
import { Section } from '../controls/section';
import { SkinPicture } from './skin-picture';
import { TriangleField } from './triangle-field';
import { useBlend } from './use-blend';

/** Beyond all and nothing of a model lies its caricature; numbers may be typed that go farther. */
const LEAST = -50;
const MOST = 150;

/** How much of each model. */
export function WeightsPanel() {
  const { state: own, actions: blend } = useBlend();
  if (!own.step.value) return null;
  const rows = blend.rows();
  const sum = blend.sum();
  return (
    <Section
      title={t('ui.blend.weights')}
      aside={
        <>
          <CommandButton command="blend.even" iconOnly />
          <span class={sum === 1 ? 'muted weight-sum' : 'warn weight-sum'}>
            {t('ui.blend.sum')} {Number((100 * sum).toFixed(1))} %
          </span>
        </>
      }
    >
      <TriangleField />
      {rows.map((row) => (
        <Row key={row.name} row={row} />
      ))}
      <Switch
        label={t('ui.blend.free')}
        title={t('ui.blend.free.help')}
        checked={own.free.value}
        onChange={(free) => {
          own.free.value = free;
        }}
      />
      {sum !== 1 && (
        <div class="buttons">
          <CommandButton command="blend.normalise" kind="solid" />
        </div>
      )}
    </Section>
  );
}

function Row({ row: { name, weight, found } }: { row: WeightRow }) {
  const { actions: blend } = useBlend();
  const short = shortName(name);
  return (
    <div class="weight-row">
      <Button
        class="picture-button"
        iconOnly
        label={t('ui.blend.only', { name: short })}
        onClick={() => blend.only(name)}
      >
        <SkinPicture name={name} />
      </Button>
      <SliderField
        label={
          found === null
            ? t('ui.blend.weight', { name: short })
            : t('ui.blend.weight.found', { name: short, found: Math.round(100 * found) })
        }
        value={100 * weight}
        min={Math.min(LEAST, 100 * weight)}
        max={Math.max(MOST, 100 * weight)}
        step={1}
        digits={1}
        onChange={(percent) => blend.setWeight(name, percent / 100, true)}
        onCommit={() => blend.edits.finish()}
      />
    </div>
  );
}
