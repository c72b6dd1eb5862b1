import { useEffect, useState } from 'preact/hooks';
import { t } from '../../app/i18n';
import type { SavedState } from '../../app/state';
import { WORKSPACES } from '../../app/wings';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Menu } from '../controls/menu';

export function TopBar({ onTogglePanel, panelOpen }: { onTogglePanel: () => void; panelOpen: boolean }) {
  const { state, commands } = useApp();
  return (
    <header class="top-bar">
      <div class="top-left">
        <Menu label={t('ui.menu')} icon="menu" iconOnly>
          {['file.open', 'file.gallery', 'file.save', 'file.save-as', 'file.restore'].map((id) => (
            <CommandButton key={id} command={id} role="menuitem" showShortcut />
          ))}
          <hr />
          {['file.export', 'file.screenshot', 'file.share'].map((id) => (
            <CommandButton key={id} command={id} role="menuitem" showShortcut />
          ))}
          <hr />
          {['view.theme', 'help.palette', 'help.shortcuts', 'help.settings'].map((id) => (
            <CommandButton key={id} command={id} role="menuitem" showShortcut />
          ))}
        </Menu>
        <h1 class="brand">{t('app.name')}</h1>
        <nav aria-label={t('ui.workspaces')} class="workspaces">
          {WORKSPACES.map((id) => (
            <Button
              key={id}
              label={t(`wing.${id}.title`)}
              pressed={state.workspace.value === id}
              onClick={() => commands.run(`workspace.${id}`)}
            />
          ))}
        </nav>
        <CommandButton command="file.gallery" />
      </div>
      <div class="top-middle">
        <span class="document-title">{state.title.value || t('ui.untitled')}</span>
        <SavedBadge saved={state.saved.value} />
      </div>
      <div class="top-right">
        <CommandButton command="edit.undo" iconOnly />
        <CommandButton command="edit.redo" iconOnly />
        <span class="divider" />
        <CommandButton command="file.share" kind="solid" />
        <CommandButton command="file.export" kind="primary" />
        <CommandButton command="help.shortcuts" iconOnly />
        <Button
          icon="panel-right"
          iconOnly
          label={t('ui.panel')}
          pressed={panelOpen}
          onClick={onTogglePanel}
        />
      </div>
    </header>
  );
}

function SavedBadge({ saved }: { saved: SavedState }) {
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    if (saved.kind !== 'saved') return;
    setNow(Date.now());
    const timer = setInterval(() => setNow(Date.now()), 5000);
    return () => clearInterval(timer);
  }, [saved]);
  return <span class={`saved ${saved.kind}`}>{savedText(saved, now)}</span>;
}

function savedText(saved: SavedState, now: number): string {
  switch (saved.kind) {
    case 'clean':
      return '';
    case 'unsaved':
      return t('ui.saved.unsaved');
    case 'saving':
      return t('ui.saved.saving');
    case 'failed':
      return t('ui.saved.failed');
    case 'saved': {
      const seconds = Math.max(0, Math.round((now - saved.time) / 1000));
      if (seconds < 3) return t('ui.saved.now');
      if (seconds < 60) return t('ui.saved.seconds', { count: seconds });
      return t('ui.saved.minutes', { count: Math.round(seconds / 60) });
    }
  }
}
