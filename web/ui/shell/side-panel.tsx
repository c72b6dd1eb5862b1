import type { ComponentType } from 'preact';
import { t } from '../../app/i18n';
import type { WorkspaceId } from '../../app/state';
import { useApp } from '../context';
import { DeformPanels } from '../deform/deform-panels';
import { HairPanels } from '../hair/hair-panels';
import { MergePanels } from '../merge/merge-panels';

const PANELS: Readonly<Record<WorkspaceId, ComponentType>> = {
  deform: DeformPanels,
  hair: HairPanels,
  merge: MergePanels,
};

export function SidePanel() {
  const Panels = PANELS[useApp().state.workspace.value];
  return (
    <aside class="side-panel" aria-label={t('ui.panel')}>
      <Panels />
    </aside>
  );
}
