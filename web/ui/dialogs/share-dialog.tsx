import { useEffect, useState } from 'preact/hooks';
import type { ShareResult } from '../../app/api';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Dialog } from '../controls/dialog';
import { Icon } from '../controls/icon';

export function ShareDialog({ onClose }: { onClose: () => void }) {
  const { share, files, messages } = useApp();
  const [result, setResult] = useState<ShareResult | null>(null);
  useEffect(() => {
    share.link().then(setResult, (error: unknown) => messages.failed(error));
  }, [share, messages]);
  const act = (work: Promise<void>) => work.catch((error: unknown) => messages.failed(error));
  return (
    <Dialog title={t('ui.share')} closeLabel={t('ui.close')} onClose={onClose}>
      {result?.kind === 'link' && (
        <>
          <p>{t('ui.share.about')}</p>
          <div class="share-link">
            <input
              class="text"
              readOnly
              aria-label={t('ui.share.link')}
              value={result.url}
              onFocus={(e) => e.currentTarget.select()}
            />
            <Button kind="primary" icon="copy" label={t('ui.share.copy')} onClick={() => act(share.copy())} />
          </div>
          <p class="muted">{t('ui.share.length', { count: result.url.length })}</p>
          <ul class="fits">
            {result.fits.map((fit) => (
              <li key={fit.where} class={fit.fits ? 'good' : 'muted'}>
                <Icon name={fit.fits ? 'check' : 'x'} />
                <span>{fit.where}</span>
                <span class="muted">{t('ui.share.limit', { count: fit.limit })}</span>
              </li>
            ))}
          </ul>
        </>
      )}
      {result?.kind === 'needs-file' && (
        <>
          <p>{result.reason}</p>
          <div class="buttons">
            <Button
              kind="primary"
              icon="save"
              label={t('ui.share.project')}
              onClick={() => {
                onClose();
                act(files.saveAs());
              }}
            />
          </div>
        </>
      )}
    </Dialog>
  );
}
