import { t } from '../../app/i18n';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';
import { SelectField } from '../controls/fields';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';
import { StepsPanel } from '../shell/steps-panel';
import { Warnings } from '../shell/warnings';
import { MeasuresPanel } from './measures-panel';
import { PartsPanel } from './parts-panel';
import { useBlend } from './use-blend';
import { WeightsPanel } from './weights-panel';

/** The side panel of the blend workspace. */
export function BlendPanels() {
  const { state } = useApp();
  const { state: own } = useBlend();
  const problem = own.problem.value;
  return (
    <>
      <MatchChoice />
      {(problem || state.warnings.value.length > 0) && (
        <div class="blend-notes">
          {problem && (
            <p class="note warn" role="alert">
              <Icon name="triangle-alert" />
              {problem}
            </p>
          )}
          <Warnings />
        </div>
      )}
      <WeightsPanel />
      <PartsPanel />
      <MeasuresPanel />
      {own.figures.value && (
        <Section title={t('ui.blend.result')}>
          <div class="buttons">
            <CommandButton command="blend.deform" kind="solid" />
            <CommandButton command="blend.another" kind="solid" />
          </div>
        </Section>
      )}
      <StepsPanel />
    </>
  );
}

/** Which of several matches is blended. */
function MatchChoice() {
  const { state: own, actions: blend } = useBlend();
  const matches = blend.matches();
  const step = own.step.value;
  if (!step || matches.length < 2) return null;
  return (
    <Section title={t('ui.blend.match')}>
      <SelectField
        label={t('ui.blend.match')}
        value={step.match}
        options={matches.map(({ id, models }) => ({ value: id, label: `${id}: ${models.join(', ')}` }))}
        onChange={(id) => blend.chooseMatch(id)}
      />
    </Section>
  );
}
