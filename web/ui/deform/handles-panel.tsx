import { t } from '../../app/i18n';
import { useApp } from '../context';

import { CommandButton } from '../controls/command-button';
import { ItemRow } from '../controls/item-row';
import { Section } from '../controls/section';
import { useDeform } from './use-deform';

export function HandlesPanel() {
  const { state: own, actions: deform } = useDeform();
  const step = own.step.value;
  if (!step) return null;
  return (
    <Section
      title={t('ui.handles')}
      aside={
        <>
          <CommandButton command="handle.new" iconOnly />
          <span class="dot handle" />
        </>
      }
    >
      {step.handles.length === 0 && <p class="muted">{t('ui.handles.none')}</p>}
      <ul class="list" aria-label={t('ui.handles')}>
        {step.handles.map((_, index) => (
          <HandleRow key={deform.handleName(index)} index={index} />
        ))}
      </ul>
      {step.handles.length > 0 && (
        <div class="buttons">
          <CommandButton command="handle.reset" kind="solid" />
        </div>
      )}
    </Section>
  );
}

function HandleRow({ index }: { index: number }) {
  const { state, document } = useApp();
  const { state: own, actions: deform } = useDeform();
  const handle = own.step.value?.handles[index];
  if (!handle) return null;
  const selected = state.selection.value.item === index;
  const isPoint = handle.kind === 'point';
  return (
    <ItemRow
      name={deform.handleName(index)}
      icon={isPoint ? 'circle-dot' : 'circle'}
      selected={selected}
      hidden={handle.hidden === true}
      onSelect={() => document.select(selected ? null : index)}
      onRename={(name) => deform.rename(index, name)}
      onHide={(hidden) => deform.hide(index, hidden)}
      onRemove={() => deform.remove(index)}
    >
      <span class="muted count">{isPoint ? t('ui.handles.point') : deform.handleSize(handle)}</span>
    </ItemRow>
  );
}
