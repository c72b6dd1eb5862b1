import { t } from '../../app/i18n';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';

/** The tools of the workspace, and below them what the taken tool offers. */
export function ToolRail() {
  const { state } = useApp();
  const painting = state.tool.value === 'paint-roi' || state.tool.value === 'paint-handle';
  const extras = painting
    ? ['brush.erase', 'brush.mirror', 'brush.larger', 'brush.smaller']
    : ['gizmo.move', 'gizmo.rotate', 'gizmo.scale'];
  return (
    <div class="tool-rail" role="toolbar" aria-label={t('ui.tools')} aria-orientation="vertical">
      {['tool.select', 'tool.paint-roi', 'tool.paint-handle', 'tool.point-handle'].map((id) => (
        <CommandButton key={id} command={id} iconOnly />
      ))}
      <span class="divider" />
      {extras.map((id) => (
        <CommandButton key={id} command={id} iconOnly />
      ))}
    </div>
  );
}
