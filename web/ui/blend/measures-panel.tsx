import type { MeasureRow } from '../../app/blend/measuring';
import { formatNumber, t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { SliderField } from '../controls/fields';
import { Section } from '../controls/section';
import { useBlend } from './use-blend';

/** Farther from what is wanted than this, as a share of it, is told. */
const MISSED = 0.005;

/** What the shape measures, and what it shall: then the weights follow. */
export function MeasuresPanel() {
  const { commands } = useApp();
  const { state: own, actions: blend } = useBlend();
  const step = own.step.value;
  if (!step) return null;
  const rows = blend.measuring.rows();
  return (
    <Section
      title={t('ui.blend.measures')}
      closed={rows.length === 0 && step.parts.length > 0}
      aside={
        <>
          <CommandButton command="blend.height" iconOnly />
          <CommandButton command="tool.measure-girth" iconOnly />
          <CommandButton command="tool.measure-length" iconOnly />
        </>
      }
    >
      {rows.length === 0 && <p class="muted">{t('ui.blend.measures.none')}</p>}
      {blend.measuring.isWanted() && <p class="muted">{t('ui.blend.measures.held')}</p>}
      {rows.map((row) => (
        <Row key={row.index} row={row} />
      ))}
      <div class="buttons">
        {rows.length === 0 && commands.isEnabled('blend.presets') && (
          <CommandButton command="blend.presets" kind="solid" />
        )}
        {blend.measuring.isWanted() && <CommandButton command="blend.keep" kind="solid" />}
      </div>
    </Section>
  );
}

function Row({ row: { index, name, reached, value, range, moves, straight } }: { row: MeasureRow }) {
  const { measuring, edits } = useBlend().actions;
  const shown = value ?? reached;
  const missed = value !== null && reached !== null && Math.abs(reached - value) > MISSED * Math.abs(value);
  return (
    <div class="measure">
      <div class="measure-head">
        <Button
          icon={value === null ? 'lock-open' : 'lock'}
          iconOnly
          pressed={value !== null}
          label={t('ui.blend.measure.hold', { name })}
          onClick={() => measuring.want(index, value === null && reached !== null ? reached : undefined)}
        />
        <span class="measure-reached">
          {reached === null ? '' : formatNumber(Number(reached.toPrecision(4)))}
          {missed && <span class="warn">{t('ui.blend.measure.missed', { value })}</span>}
        </span>
        {straight !== null && (
          <Button
            icon="slash"
            iconOnly
            pressed={straight}
            label={t('ui.blend.measure.straight', { name })}
            onClick={() => measuring.straighten(index, !straight)}
          />
        )}
        {moves && (
          <>
            <Button
              icon="chevron-up"
              iconOnly
              label={t('ui.blend.measure.up', { name })}
              onClick={() => measuring.move(index, 1)}
            />
            <Button
              icon="chevron-down"
              iconOnly
              label={t('ui.blend.measure.down', { name })}
              onClick={() => measuring.move(index, -1)}
            />
          </>
        )}
        <Button
          icon="x"
          iconOnly
          label={t('ui.blend.measure.remove', { name })}
          onClick={() => measuring.remove(index)}
        />
      </div>
      {shown !== null && range && (
        <SliderField
          label={name}
          value={shown}
          min={range[0]}
          max={range[1]}
          step={stepOf(range)}
          digits={4}
          onChange={(next) => measuring.want(index, next, true)}
          onCommit={() => edits.finish()}
        />
      )}
    </div>
  );
}

/** A round number of which some two hundred make the slider. */
const stepOf = ([low, high]: readonly [number, number]): number =>
  10 ** Math.floor(Math.log10((high - low) / 100 || 1));
