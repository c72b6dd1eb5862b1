import { useState } from 'preact/hooks';
import type { ExportFormat } from '../../app/api';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Dialog } from '../controls/dialog';
import { Segments, SelectField, Switch } from '../controls/fields';

interface Choice<F extends string> {
  readonly format: F;
  readonly label: string;
  readonly keeps: string;
}

export function ExportDialog({ onClose }: { onClose: () => void }) {
  const { files, messages } = useApp();
  const group = files.exportGroup();
  const [what, setWhat] = useState<'group' | 'model'>(group ? 'group' : 'model');
  const [format, setFormat] = useState<ExportFormat>(files.exportChoices[0]?.format ?? 'glb');
  const [own, setOwn] = useState(group?.choices[0]?.format ?? '');
  const [option, setOption] = useState(false);
  const models = files.exportModels();
  const [number, setNumber] = useState(0);
  const ofGroup = what === 'group' ? group : undefined;
  const save = () => {
    onClose();
    const saved = ofGroup
      ? files.exportOf(ofGroup, own, option)
      : files.exportModel(format, models.length > 0 ? number : undefined);
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
      {group && (
        <Segments
          label={t('ui.export.what')}
          value={what}
          options={[
            { value: 'group', label: group.label },
            { value: 'model', label: group.besideLabel },
          ]}
          onChange={setWhat}
        />
      )}
      {ofGroup ? (
        <>
          <Choices choices={ofGroup.choices} value={own} onChange={setOwn} />
          {ofGroup.option && <Switch label={ofGroup.option} checked={option} onChange={setOption} />}
        </>
      ) : (
        <>
          {models.length > 0 && (
            <SelectField
              label={t('ui.export.which')}
              value={String(number)}
              options={models.map(({ name }, at) => ({ value: String(at), label: name }))}
              onChange={(at) => setNumber(Number(at))}
            />
          )}
          <Choices choices={files.exportChoices} value={format} onChange={setFormat} />
        </>
      )}
      <p class="muted">{ofGroup?.about ?? t('ui.export.topology')}</p>
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
