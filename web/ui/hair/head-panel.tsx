import { t } from '../../app/i18n';
import { useApp } from '../context';

import { CommandButton } from '../controls/command-button';
import { SelectField } from '../controls/fields';
import { Section } from '../controls/section';
import { useHair } from './use-hair';

const OWN = '';

/** The head that hair grows on, and where on it. */
export function HeadPanel() {
  const { state, gallery, messages } = useApp();
  const { state: own, actions: hair } = useHair();
  const step = own.step.value;
  const model = state.model.value;
  if (!step) return null;
  const heads = gallery.entries.value.filter(({ scalp, recipe }) => scalp && !recipe);
  const ref = state.recipe.value.models[step.model];
  const current = ref && 'builtin' in ref ? ref.builtin : OWN;
  const known = heads.some(({ name }) => name === current);
  const options = heads.map(({ name, title }) => ({ value: name, label: title }));
  const scalp = hair.scalpSize();
  return (
    <Section title={t('ui.hair.head')}>
      {options.length > 0 && (
        <SelectField
          label={t('ui.hair.head.model')}
          value={known ? current : OWN}
          options={known ? options : [{ value: OWN, label: model?.name ?? step.model }, ...options]}
          onChange={(name) => {
            if (name !== OWN) hair.setHead(name).catch((error: unknown) => messages.failed(error));
          }}
        />
      )}
      <p class="muted">{scalp > 0 ? t('ui.hair.scalp', { count: scalp }) : t('ui.hair.scalp.none')}</p>
      <div class="buttons">
        <CommandButton command="tool.paint-scalp" kind="solid" />
      </div>
    </Section>
  );
}
