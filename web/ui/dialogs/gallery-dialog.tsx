import { useRef } from 'preact/hooks';
import type { GalleryEntry } from '../../app/api';
import { t } from '../../app/i18n';
import { WORKSPACES } from '../../app/wings';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Dialog } from '../controls/dialog';

export function GalleryDialog({ onClose }: { onClose: () => void }) {
  const { state, gallery, files, messages } = useApp();
  const entries = gallery.entries.value;
  const chosen = useRef(false);
  const open = (entry: GalleryEntry) => {
    chosen.current = true;
    onClose();
    gallery.open(entry).catch((error: unknown) => messages.failed(error));
  };
  const group = (title: string, list: readonly GalleryEntry[]) =>
    list.length > 0 && (
      <section key={title}>
        <h3 class="gallery-title">{title}</h3>
        <ul class="gallery">
          {list.map((entry) => (
            <li key={entry.recipe ?? entry.name}>
              <button type="button" class="card" onClick={() => open(entry)} title={entry.licence}>
                <img src={entry.thumbnail} alt="" loading="lazy" width="256" height="192" />
                <span class="card-title">{entry.title}</span>
                <span class="muted">
                  {t(entry.made ? 'ui.gallery.made' : 'ui.figure.vertices', { count: entry.vertices })}
                </span>
              </button>
            </li>
          ))}
        </ul>
      </section>
    );
  // What is worked on comes first.
  const current = state.workspace.value;
  const workspaces = [current, ...WORKSPACES.filter((id) => id !== current)];
  return (
    <Dialog
      wide
      title={t('ui.gallery')}
      closeLabel={t('ui.close')}
      onClose={onClose}
      returns={() => !chosen.current}
      footer={
        <Button
          kind="solid"
          icon="folder-open"
          label={t('ui.gallery.own')}
          onClick={() => {
            onClose();
            files.open().catch((error: unknown) => messages.failed(error));
          }}
        />
      }
    >
      {workspaces.map((id) =>
        group(
          t(`wing.${id}.gallery`),
          entries.filter((entry) => entry.recipe && entry.workspace === id),
        ),
      )}
      {group(
        t('ui.gallery.models'),
        entries.filter((entry) => !entry.recipe),
      )}
    </Dialog>
  );
}
