import { t } from '../../app/i18n';
import { TOOLS, type ToolId } from '../../app/state';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';

const BRUSH = ['brush.erase', 'brush.larger', 'brush.smaller'];

/** What the taken tool offers beside itself. */
function extras(tool: ToolId): readonly string[] {
  switch (tool) {
    case 'paint-roi':
    case 'paint-handle':
    case 'paint-scalp':
    case 'paint-length':
      return ['brush.mirror', ...BRUSH];
    case 'select':
    case 'point-handle':
      return ['gizmo.move', 'gizmo.rotate', 'gizmo.scale'];
    case 'mark-region':
    case 'mark-feature':
      return ['merge.through', ...BRUSH];
    case 'merge-pins':
      return ['merge.remove-pin'];
    case 'hint':
      return ['brush.mirror', 'hair.support-kind', 'hair.rebuild-support'];
    case 'ponytail':
      return ['brush.mirror', 'hair.rebuild-support', 'hair.done'];
    default:
      return ['brush.mirror'];
  }
}

/** The tools of the workspace, and below them what the taken tool offers. */
export function ToolRail() {
  const { state } = useApp();
  return (
    <div class="tool-rail" role="toolbar" aria-label={t('ui.tools')} aria-orientation="vertical">
      {TOOLS[state.workspace.value].map((id) => (
        <CommandButton key={id} command={`tool.${id}`} iconOnly />
      ))}
      <span class="divider" />
      {extras(state.tool.value).map((id) => (
        <CommandButton key={id} command={id} iconOnly />
      ))}
    </div>
  );
}
