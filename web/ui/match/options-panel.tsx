import { t } from '../../app/i18n';
import type { MatchStep } from '../../recipe/recipe';
import { CommandButton } from '../controls/command-button';
import { NumberField, SelectField, SliderField, Switch } from '../controls/fields';
import { Section } from '../controls/section';
import { useMatch } from './use-match';

const FIRST = ['automatic', 'copy', 'remesh', 'wrap', 'box', 'sphere', 'torus'] as const;
const METHODS = ['graph', 'paper'] as const;
const TOGETHER = ['all', 'pairs'] as const;
const STARTS = ['automatic', 'similarity', 'radial'] as const;
/** Degrees: a bevel is below, a corner above. */
const USUAL_ANGLE = 40;

/** What most matches do without. */
export function OptionsPanel() {
  const { state: own, actions: match } = useMatch();
  const step = own.step.value;
  if (!step) return null;
  return (
    <Section title={t('ui.match.advanced')} closed>
      <Surface step={step} />
      <SelectField
        label={t('ui.match.first')}
        value={step.first ?? 'automatic'}
        options={FIRST.map((value) => ({ value, label: t(`ui.match.first.${value}`) }))}
        onChange={(value) => match.set({ first: value === 'automatic' ? undefined : value })}
      />
      {step.first === 'wrap' && (
        <SliderField
          label={t('ui.match.genus')}
          value={step.genus ?? 0}
          min={0}
          max={20}
          step={1}
          digits={0}
          onChange={(genus) => match.set({ genus: Math.round(genus) }, true)}
          onCommit={() => match.edits.finish()}
        />
      )}
      <SelectField
        label={t('ui.match.start')}
        value={step.start}
        options={STARTS.map((value) => ({ value, label: t(`ui.match.start.${value}`) }))}
        onChange={(start) => match.set({ start })}
      />
      <SelectField
        label={t('ui.match.method')}
        value={step.method}
        options={METHODS.map((value) => ({ value, label: t(`ui.match.method.${value}`) }))}
        onChange={(method) => match.set({ method })}
      />
      {step.models.length > 2 && (
        <SelectField
          label={t('ui.match.together')}
          value={step.together ? 'all' : 'pairs'}
          options={TOGETHER.map((value) => ({ value, label: t(`ui.match.together.${value}`) }))}
          onChange={(value) => match.set({ together: value === 'all' })}
        />
      )}
    </Section>
  );
}

/** How many edges the angle finds on each model, and the tool that picks more. */
function Kept({ step }: { step: MatchStep }) {
  const { state: own } = useMatch();
  const found = own.kept.value;
  return (
    <>
      {step.sharpAngle !== undefined && found.length === step.models.length && (
        <p class="muted">
          {step.models
            .map((name, at) => t('ui.match.sharp.found', { name, count: found[at]!.length }))
            .join(' · ')}
        </p>
      )}
      <div class="buttons">
        <CommandButton command="tool.match-sharp" kind="solid" />
      </div>
    </>
  );
}

/** Sharp edges, and how fine the skins are. */
function Surface({ step }: { step: MatchStep }) {
  const { actions: match } = useMatch();
  const finish = () => match.edits.finish();
  return (
    <>
      <Switch
        label={t('ui.match.sharp')}
        title={t('ui.match.sharp-angle.help')}
        checked={step.sharpAngle !== undefined}
        onChange={(on) => match.set({ sharpAngle: on ? USUAL_ANGLE : undefined })}
      />
      {step.sharpAngle !== undefined && (
        <SliderField
          label={t('ui.match.sharp-angle')}
          value={step.sharpAngle}
          min={10}
          max={120}
          step={1}
          digits={0}
          onChange={(sharpAngle) => match.set({ sharpAngle }, true)}
          onCommit={finish}
        />
      )}
      <Kept step={step} />
      <div class="field" title={t('ui.match.edge-length.help')}>
        <span class="label">{t('ui.match.edge-length')}</span>
        <NumberField
          label={t('ui.match.edge-length')}
          value={step.edgeLength ?? 0}
          min={0}
          step={0.001}
          digits={5}
          onChange={(length) => match.set({ edgeLength: length > 0 ? length : undefined }, true)}
          onCommit={finish}
        />
      </div>
      <SliderField
        label={t('ui.match.adapt')}
        value={100 * step.adapt}
        min={0}
        max={100}
        step={5}
        digits={0}
        onChange={(part) => match.set({ adapt: part / 100 }, true)}
        onCommit={finish}
      />
    </>
  );
}
