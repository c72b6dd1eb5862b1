import { useState } from 'preact/hooks';
import type { ExportFormat, StrandChoice } from '../../app/api';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Dialog } from '../controls/dialog';
import { Segments, Switch } from '../controls/fields';

interface Choice<F extends string> {
  readonly format: F;
  readonly label: string;
  readonly keeps: string;
}

export function ExportDialog({ onClose }: { onClose: () => void }) {
  const { state, files, messages } = useApp();
  const hasHair = state.workspace.value === 'hair';
  const [what, setWhat] = useState<'strands' | 'head'>(hasHair ? 'strands' : 'head');
  const [format, setFormat] = useState<ExportFormat>(files.exportChoices[0]?.format ?? 'glb');
  const [strands, setStrands] = useState<StrandChoice['format']>(files.strandChoices[0]?.format ?? 'abc');
  const [guidesOnly, setGuidesOnly] = useState(false);
  const save = () => {
    onClose();
    const saved = what === 'head' ? files.exportModel(format) : files.exportStrands(strands, guidesOnly);
    saved.catch((error: unknown) => messages.failed(error));
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
      {hasHair && (
        <Segments
          label={t('ui.export.what')}
          value={what}
          options={(['strands', 'head'] as const).map((value) => ({ value, label: t(`ui.export.${value}`) }))}
          onChange={setWhat}
        />
      )}
      {what === 'head' ? (
        <Choices choices={files.exportChoices} value={format} onChange={setFormat} />
      ) : (
        <>
          <Choices choices={files.strandChoices} value={strands} onChange={setStrands} />
          <Switch label={t('ui.export.guides')} checked={guidesOnly} onChange={setGuidesOnly} />
        </>
      )}
      <p class="muted">{t(what === 'head' ? 'ui.export.topology' : 'ui.export.strands.about')}</p>
    </Dialog>
  );
}

interface ChoicesProps<F extends string> {
  choices: readonly Choice<F>[];
  value: F;
  onChange: (format: F) => void;
}

function Choices<F extends string>({ choices, value, onChange }: ChoicesProps<F>) {
  return (
    <fieldset class="choices">
      <legend class="visually-hidden">{t('ui.export.format')}</legend>
      {choices.map((choice) => (
        <label key={choice.format} class="choice">
          <input
            type="radio"
            name="format"
            value={choice.format}
            checked={value === choice.format}
            onChange={() => onChange(choice.format)}
          />
          <span>
            <strong>{choice.label}</strong>
            <span class="muted">{choice.keeps}</span>
          </span>
        </label>
      ))}
    </fieldset>
  );
}
