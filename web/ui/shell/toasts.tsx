import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Icon } from '../controls/icon';

const ICONS = { info: 'info', good: 'check', warn: 'triangle-alert', bad: 'circle-x' } as const;

export function Toasts() {
  const { state, messages, reload } = useApp();
  return (
    <div class="toasts" role="log" aria-live="polite" aria-label={t('ui.messages')}>
      {state.updateReady.value && (
        <div class="toast info">
          <Icon name="sparkles" />
          <span>{t('ui.update')}</span>
          <Button kind="solid" label={t('ui.update.reload')} onClick={reload} />
        </div>
      )}
      {state.toasts.value.map((toast) => (
        <div key={toast.id} class={`toast ${toast.kind}`}>
          <Icon name={ICONS[toast.kind]} />
          <span>{toast.text}</span>
          {toast.action && (
            <Button
              kind="solid"
              label={toast.action.label}
              onClick={() => {
                toast.action?.run();
                messages.dismiss(toast.id);
              }}
            />
          )}
          <Button icon="x" iconOnly label={t('ui.dismiss')} onClick={() => messages.dismiss(toast.id)} />
        </div>
      ))}
    </div>
  );
}
