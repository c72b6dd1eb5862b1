import { formatNumber, t } from '../../app/i18n';
import { boxOf, sizeOf } from '../../core/box';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { SelectField, SliderField } from '../controls/fields';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';
import { StepsPanel } from '../shell/steps-panel';
import { useDress } from './use-dress';

/** Share of the body's size that the slider goes to; less may be typed. */
const MOST = 0.04;
const TIGHTEST = 0.01;

/** The side panel of the dress workspace. */
export function DressPanels() {
  const { state } = useApp();
  const choosing = state.choosing.value !== null;
  return (
    <>
      <GarmentsPanel />
      {!choosing && <FitPanel />}
      {!choosing && <ResultPanel />}
      {!choosing && <StepsPanel />}
    </>
  );
}

/** All that is worn in the document; one of them is open. */
function GarmentsPanel() {
  const { state, document } = useApp();
  const { state: own, actions: dress } = useDress();
  const choosing = state.choosing.value !== null;
  const garments = dress.garments();
  const open = own.step.value?.id;
  if (garments.length === 0) return null;
  return (
    <Section
      title={t('ui.dress.garments')}
      aside={
        !choosing && (
          <>
            <CommandButton command="dress.garment" iconOnly />
            <CommandButton command="dress.add" iconOnly />
          </>
        )
      }
    >
      <ul class="list" aria-label={t('ui.dress.garments')}>
        {garments.map(({ id, garment, to }) => (
          <li key={id} class={id === open ? 'row selected' : 'row'}>
            <button
              type="button"
              class="row-main"
              aria-pressed={id === open}
              disabled={choosing}
              onClick={() => document.openStep(id)}
            >
              <Icon name="shirt" />
              <span>{garment}</span>
              <span class="muted count">{to}</span>
            </button>
            <Button
              icon="trash-2"
              iconOnly
              disabled={choosing}
              label={t('ui.dress.remove', { name: garment })}
              onClick={() => document.removeStep(id)}
            />
          </li>
        ))}
      </ul>
    </Section>
  );
}

/** Between which bodies, and how loosely. */
function FitPanel() {
  const { state: own, actions: dress } = useDress();
  const step = own.step.value;
  if (!step) return null;
  const bodies = dress.bodies().map((name) => ({ value: name, label: name }));
  const matches = dress.matches();
  const size = own.source.value ? Math.max(...sizeOf(boxOf(own.source.value.model.positions))) : 1;
  return (
    <Section title={t('ui.dress.fit')}>
      {matches.length > 1 && (
        <SelectField
          label={t('ui.dress.bodies')}
          value={step.match}
          options={matches.map(({ id }) => ({ value: id, label: id }))}
          onChange={(id) => dress.chooseMatch(id)}
        />
      )}
      <SelectField
        label={t('ui.dress.from')}
        value={step.from}
        options={bodies}
        onChange={(name) => dress.setFrom(name)}
      />
      <SelectField
        label={t('ui.dress.to')}
        value={step.to}
        options={bodies}
        onChange={(name) => dress.setTo(name)}
      />
      <div title={t('ui.dress.offset.help')}>
        <SliderField
          label={t('ui.dress.offset')}
          value={step.offset}
          min={Math.min(step.offset, rounded(-TIGHTEST * size))}
          max={Math.max(step.offset, rounded(MOST * size))}
          step={10 ** Math.floor(Math.log10((MOST * size) / 50))}
          digits={4}
          onChange={(offset) => dress.setOffset(offset, true)}
          onCommit={() => dress.edits.finish()}
        />
      </div>
    </Section>
  );
}

const rounded = (length: number): number => Number(length.toPrecision(2));

/** Whether it fits, and where to go from here. */
function ResultPanel() {
  const figures = useDress().state.figures.value;
  if (!figures) return null;
  return (
    <Section title={t('ui.dress.result')}>
      <dl class="figures">
        <dt>{t('ui.dress.figure.inside')}</dt>
        <dd class={figures.after === 0 ? 'good' : 'bad'}>{formatNumber(figures.after)}</dd>
        <dt>{t('ui.dress.figure.inside-before')}</dt>
        <dd>{formatNumber(figures.before)}</dd>
      </dl>
      <div class="buttons">
        <CommandButton command="dress.another" kind="solid" />
        <CommandButton command="dress.deform" kind="solid" />
      </div>
    </Section>
  );
}
