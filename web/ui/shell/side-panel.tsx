import { t } from '../../app/i18n';
import { useFace } from '../context';

export function SidePanel() {
  const Panels = useFace()?.Panels;
  return (
    <aside class="side-panel" aria-label={t('ui.panel')}>
      {Panels && <Panels />}
    </aside>
  );
}
