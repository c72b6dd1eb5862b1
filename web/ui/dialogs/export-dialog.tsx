import { useState } from 'preact/hooks';
import type { ExportFormat } from '../../app/api';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Dialog } from '../controls/dialog';

export function ExportDialog({ onClose }: { onClose: () => void }) {
  const { files, messages } = useApp();
  const [format, setFormat] = useState<ExportFormat>(files.exportChoices[0]?.format ?? 'glb');
  const save = () => {
    onClose();
    files.exportModel(format).catch((error: unknown) => messages.failed(error));
  };
  return (
    <Dialog
      title={t('ui.export')}
      closeLabel={t('ui.close')}
      onClose={onClose}
      footer={
        <>
          <Button label={t('ui.cancel')} onClick={onClose} />
          <Button kind="primary" icon="download" label={t('ui.export.save')} onClick={save} data-first />
        </>
      }
    >
      <fieldset class="choices">
        <legend class="visually-hidden">{t('ui.export.format')}</legend>
        {files.exportChoices.map((choice) => (
          <label key={choice.format} class="choice">
            <input
              type="radio"
              name="format"
              value={choice.format}
              checked={format === choice.format}
              onChange={() => setFormat(choice.format)}
            />
            <span>
              <strong>{choice.label}</strong>
              <span class="muted">{choice.keeps}</span>
            </span>
          </label>
        ))}
      </fieldset>
      <p class="muted">{t('ui.export.topology')}</p>
    </Dialog>
  );
}
