import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';

/** The place of the part while there is none: gallery models, or a file of one's own. */
export function PartChooser() {
  const { gallery, merge, files, messages } = useApp();
  const models = gallery.entries.value.filter(({ recipe }) => !recipe);
  return (
    <section class="part-chooser" aria-label={t('ui.merge.choose')}>
      <header>
        <h2>{t('ui.merge.choose')}</h2>
        <Button
          kind="solid"
          icon="folder-open"
          label={t('ui.merge.choose.file')}
          onClick={() => {
            files.open().catch((error: unknown) => messages.failed(error));
          }}
        />
        <Button
          icon="x"
          iconOnly
          label={t('ui.cancel')}
          onClick={() => {
            merge.cancelChoosing().catch((error: unknown) => messages.failed(error));
          }}
        />
      </header>
      <p class="muted">{t('ui.merge.choose.help')}</p>
      <ul class="gallery">
        {models.map(({ name, title, thumbnail, licence }) => (
          <li key={name}>
            <button
              type="button"
              class="card"
              title={licence}
              onClick={() => merge.choosePart(name, { builtin: name })}
            >
              <img src={thumbnail} alt="" loading="lazy" width="256" height="192" />
              <span class="card-title">{title}</span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
