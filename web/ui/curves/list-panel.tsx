import { t } from '../../app/i18n';
import { linkOf } from '../../recipe/steps/curves-edits';
import { itemOf } from '../../tools/curves/items';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';
import { ItemRow } from '../controls/item-row';
import { Section } from '../controls/section';
import { useCurves } from './use-curves';

const ICONS = { skeleton: 'bone', surface: 'spline', contour: 'feather' } as const;

/** The curves of the step; each with what it hangs on. */
export function ListPanel() {
  const { document } = useApp();
  const { state: own, actions: curves } = useCurves();
  const step = own.step.value;
  if (!step) return null;
  const selected = own.grip.value?.curve;
  return (
    <Section title={t('ui.curves')}>
      {step.curves.length === 0 && <p class="muted">{t('ui.curves.none')}</p>}
      <ul class="list" aria-label={t('ui.curves')}>
        {step.curves.map(({ id, kind }, index) => {
          const parent = linkOf(step, id)?.parent;
          return (
            <ItemRow
              key={id}
              name={id}
              icon={ICONS[kind]}
              selected={selected === index}
              hidden={own.hidden.value.has(id)}
              onSelect={() =>
                document.select(selected === index ? null : itemOf({ curve: index, point: null }))
              }
              onRename={(name) => curves.rename(id, name)}
              onHide={(hidden) => curves.hide(id, hidden)}
              onRemove={() => curves.remove(id)}
            >
              {parent && <span class="muted count">{t('ui.curves.on', { name: parent })}</span>}
            </ItemRow>
          );
        })}
      </ul>
      <div class="buttons">
        <CommandButton command="curves.propose" kind="solid" />
        {step.curves.length > 0 && <CommandButton command="curves.reset-all" kind="solid" />}
      </div>
    </Section>
  );
}
