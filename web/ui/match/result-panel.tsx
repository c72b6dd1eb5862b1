import { t } from '../../app/i18n';
import { WORKSPACES, wings } from '../../app/wings';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { SelectField } from '../controls/fields';
import { Section } from '../controls/section';
import { useMatch } from './use-match';

/** A pose is given to a model, not begun on one. */
const ELSEWHERE: readonly string[] = ['match', 'transfer'];

/** Where to go from here with the skins. */
export function ResultPanel() {
  const { workspaces, messages } = useApp();
  const { state: own } = useMatch();
  const result = own.result.value;
  if (!result || own.growing.value) return null;
  const chosen = Math.min(own.chosen.value, result.models.length - 1);
  return (
    <Section title={t('ui.match.result')}>
      <SelectField
        label={t('ui.match.which')}
        value={String(chosen)}
        options={result.of.models.map((label, at) => ({ value: String(at), label }))}
        onChange={(at) => {
          own.chosen.value = Number(at);
        }}
      />
      <div class="buttons">
        {WORKSPACES.filter((id) => !ELSEWHERE.includes(id)).map((id) => (
          <Button
            key={id}
            kind="solid"
            icon={wings[id].icon}
            label={t(`wing.${id}.title`)}
            onClick={() => {
              workspaces.goOn(id).catch((error: unknown) => messages.failed(error));
            }}
          />
        ))}
      </div>
      <div class="buttons">
        <CommandButton command="file.export" kind="solid" />
      </div>
    </Section>
  );
}
