import type { ComponentType } from 'preact';
import type { DialogId } from '../../app/state';
import { useApp } from '../context';
import { ExportDialog } from './export-dialog';
import { GalleryDialog } from './gallery-dialog';
import { HelpDialog } from './help-dialog';
import { ImportReportDialog } from './import-report-dialog';
import { Palette } from './palette';
import { RestoreDialog } from './restore-dialog';
import { SettingsDialog } from './settings-dialog';
import { ShareDialog } from './share-dialog';

const DIALOGS: Record<DialogId, ComponentType<{ onClose: () => void }>> = {
  gallery: GalleryDialog,
  export: ExportDialog,
  share: ShareDialog,
  'import-report': ImportReportDialog,
  help: HelpDialog,
  settings: SettingsDialog,
  palette: Palette,
  restore: RestoreDialog,
};

/** The dialog that is open, if any. */
export function Dialogs() {
  const { state } = useApp();
  const id = state.dialog.value;
  if (!id) return null;
  const Open = DIALOGS[id];
  return (
    <Open
      key={id}
      onClose={() => {
        if (state.dialog.peek() === id) state.dialog.value = null;
      }}
    />
  );
}
