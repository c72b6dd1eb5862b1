import { t } from '../../app/i18n';

import { CommandButton } from '../controls/command-button';
import { Segments } from '../controls/fields';
import { Section } from '../controls/section';
import { useHair } from './use-hair';

/** What is drawn beside the hair, and where hint strokes get their depth from. */
export function ShowPanel() {
  const { state: own } = useHair();
  const kind = own.supportKind;
  return (
    <Section title={t('ui.hair.show')} closed>
      <div class="buttons">
        {(['hair', 'curves', 'support', 'field', 'constraints', 'volume'] as const).map((what) => (
          <CommandButton key={what} command={`hair.show-${what}`} kind="solid" />
        ))}
      </div>
      <div class="field">
        <span class="label">{t('ui.hair.support')}</span>
        <Segments
          label={t('ui.hair.support')}
          value={kind.value}
          options={(['strip', 'ruled'] as const).map((value) => ({
            value,
            label: t(`ui.hair.support.${value}`),
          }))}
          onChange={(value) => {
            kind.value = value;
          }}
        />
      </div>
      <div class="buttons">
        <CommandButton command="hair.rebuild-support" kind="solid" />
      </div>
    </Section>
  );
}
