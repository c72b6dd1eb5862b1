import { useState } from 'preact/hooks';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';

export function HandlesPanel() {
  const { state, deform } = useApp();
  const step = state.step.value;
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
  const { state, deform, document } = useApp();
  const [renaming, setRenaming] = useState(false);
  const handle = state.step.value?.handles[index];
  if (!handle) return null;
  const name = deform.handleName(index);
  const selected = state.selection.value.handle === index;
  return (
    <li class={selected ? 'row selected' : 'row'}>
      {renaming ? (
        <input
          class="text"
          aria-label={t('ui.handles.rename', { name })}
          value={name}
          maxLength={64}
          ref={(input) => input?.focus()}
          onBlur={(e) => {
            setRenaming(false);
            const typed = e.currentTarget.value.trim();
            if (typed && typed !== name) deform.rename(index, typed);
          }}
          onKeyDown={(e) => {
            if (e.key === 'Escape') e.currentTarget.value = name;
            if (e.key === 'Enter' || e.key === 'Escape') e.currentTarget.blur();
          }}
        />
      ) : (
        <button
          type="button"
          class="row-main"
          aria-pressed={selected}
          onClick={() => document.select(selected ? null : index)}
          onDblClick={() => setRenaming(true)}
        >
          <Icon name={handle.kind === 'point' ? 'circle-dot' : 'circle'} />
          <span>{name}</span>
          <span class="muted count">
            {handle.kind === 'point' ? t('ui.handles.point') : deform.handleSize(handle)}
          </span>
        </button>
      )}
      {selected && (
        <Button
          icon="pencil"
          iconOnly
          label={t('ui.handles.rename', { name })}
          onClick={() => setRenaming(true)}
        />
      )}
      <Button
        icon={handle.hidden ? 'eye-off' : 'eye'}
        iconOnly
        pressed={handle.hidden === true}
        label={t('ui.handles.hide', { name })}
        onClick={() => deform.hide(index, !handle.hidden)}
      />
      <Button
        icon="trash-2"
        iconOnly
        label={t('ui.handles.remove', { name })}
        onClick={() => deform.remove(index)}
      />
    </li>
  );
}
