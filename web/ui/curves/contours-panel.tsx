import { t } from '../../app/i18n';
import { CommandButton } from '../controls/command-button';
import { SliderField, Switch } from '../controls/fields';
import { Section } from '../controls/section';
import { useCurves } from './use-curves';

/** The drawing of the view, and the line in hand. */
export function ContoursPanel() {
  const { state, actions } = useCurves();
  const { contours } = state;
  if (!contours.on.value) return null;
  const problem = contours.problem.value;
  return (
    <Section title={t('ui.contours')}>
      {problem && <p class="muted">{t(`ui.contours.${problem}`)}</p>}
      {(problem === 'stopped' || problem === 'failed') && (
        <div class="buttons">
          <CommandButton command="curves.contours.again" kind="solid" />
        </div>
      )}
      <Counts />
      <SliderField
        label={t('ui.contours.detail')}
        value={Math.round(100 * contours.detail.value)}
        min={0}
        max={100}
        step={5}
        digits={0}
        onChange={(percent) => {
          contours.detail.value = percent / 100;
        }}
      />
      <SliderField
        label={t('ui.contours.smoothing')}
        value={contours.smoothing.value}
        min={0}
        max={60}
        step={1}
        digits={0}
        onChange={(sweeps) => {
          contours.smoothing.value = Math.round(sweeps);
        }}
      />
      <Switch
        label={t('command.curves.contours.suggestive')}
        checked={contours.suggestive.value}
        onChange={(on) => {
          contours.suggestive.value = on;
        }}
      />
      <Switch
        label={t('command.curves.contours.beside')}
        checked={contours.beside.value}
        onChange={(on) => {
          contours.beside.value = on;
          actions.hand.settle('beside');
        }}
      />
      <Reach />
    </Section>
  );
}

function Counts() {
  const lines = useCurves().state.contours.lines.value;
  if (!lines) return null;
  const fine = lines.suggestive.reduce((sum, flag) => sum + flag, 0);
  return <p class="muted">{t('ui.contours.count', { contours: lines.suggestive.length - fine, fine })}</p>;
}

/** Of the line in hand. */
function Reach() {
  const { state, actions } = useCurves();
  const held = state.contours.hand.value;
  const { size } = actions.hand;
  if (!held || !(size > 0)) return <p class="muted">{t('ui.contours.none')}</p>;
  return (
    <SliderField
      label={t('ui.contours.reach')}
      value={(100 * held.picked.reach) / size}
      min={1}
      max={60}
      step={0.5}
      digits={1}
      onChange={(percent) => actions.hand.reach((percent / 100) * size)}
      onCommit={() => actions.hand.settle('pull-reach')}
    />
  );
}
