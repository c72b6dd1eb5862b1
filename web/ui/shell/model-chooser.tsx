import type { ComponentChildren } from 'preact';
import type { GalleryEntry } from '../../app/api';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';

interface Props {
  /** What is asked for. */
  title: string;
  help: string;
  onCancel: () => void;
  /** Models that come before the others. */
  first?: (entry: GalleryEntry) => boolean;
  /** What else may be chosen. */
  children?: ComponentChildren;
}

/** The place of a model while there is none: gallery models, or a file of one's own. */
export function ModelChooser({ title, help, onCancel, first = () => false, children }: Props) {
  const { state, gallery, files, messages } = useApp();
  const bare = gallery.entries.value.filter(({ recipe }) => !recipe);
  const models = [...bare.filter(first), ...bare.filter((entry) => !first(entry))];
  return (
    <section class="model-chooser" aria-label={title}>
      <header>
        <h2>{title}</h2>
        <Button
          kind="solid"
          icon="folder-open"
          label={t('ui.choose.file')}
          onClick={() => {
            files.open().catch((error: unknown) => messages.failed(error));
          }}
        />
        <Button icon="x" iconOnly label={t('ui.cancel')} onClick={onCancel} />
      </header>
      <p class="muted">{help}</p>
      {children}
      <ul class="gallery">
        {models.map(({ name, title: shown, thumbnail, licence }) => (
          <li key={name}>
            <button
              type="button"
              class="card"
              title={licence}
              onClick={() => state.choosing.value?.choose(name, { builtin: name })}
            >
              <img src={thumbnail} alt="" loading="lazy" width="256" height="192" />
              <span class="card-title">{shown}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
