import { useEffect, useState } from 'preact/hooks';
import type { RestorePoint } from '../../app/api';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Dialog } from '../controls/dialog';
import { Icon } from '../controls/icon';

export function RestoreDialog({ onClose }: { onClose: () => void }) {
  const { autosave, messages } = useApp();
  const [points, setPoints] = useState<readonly RestorePoint[] | null>(null);
  useEffect(() => {
    autosave.restorePoints().then(setPoints, (error: unknown) => messages.failed(error));
  }, [autosave, messages]);
  return (
    <Dialog title={t('ui.restore')} closeLabel={t('ui.close')} onClose={onClose}>
      <p class="muted">{t('ui.restore.about')}</p>
      {points?.length === 0 && <p>{t('ui.restore.none')}</p>}
      <ul class="list">
        {points?.map((point) => (
          <li key={point.id} class="row">
            <span class="row-main">
              <Icon name={point.kind === 'kept' ? 'file-box' : 'history'} />
              <span>
                {point.title || t('ui.untitled')}
                <span class="muted">
                  {' '}
                  {new Date(point.time).toLocaleString()} · {t('ui.restore.counts', { count: point.handles })}
                </span>
              </span>
            </span>
            {point.current ? (
              <span class="muted">{t('ui.restore.current')}</span>
            ) : (
              <Button
                kind="solid"
                label={t('ui.restore.open')}
                onClick={() => {
                  onClose();
                  autosave.restore(point.id).catch((error: unknown) => messages.failed(error));
                }}
              />
            )}
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
