import { t } from '../../app/i18n';
import { useApp, useFace } from '../context';
import { CommandButton } from '../controls/command-button';

/** The tools of the workspace, and below them what the taken tool offers. */
export function ToolRail() {
  const { state, wings } = useApp();
  const face = useFace();
  return (
    <div class="tool-rail" role="toolbar" aria-label={t('ui.tools')} aria-orientation="vertical">
      {wings.open.value?.wing.tools.map((id) => (
        <CommandButton key={id} command={`tool.${id}`} iconOnly />
      ))}
      <span class="divider" />
      {face?.extras(state.tool.value).map((id) => (
        <CommandButton key={id} command={id} iconOnly />
      ))}
    </div>
  );
}
