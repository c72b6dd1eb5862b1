import { t } from '../../app/i18n';
import { strandCount } from '../../core/strands';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';

/** Says whose strands are on screen while a file of them is looked at, and leads back. */
export function ViewedBar() {
  const shown = useApp().state.hair.viewed.value;
  if (!shown) return null;
  const { name, strands, on } = shown;
  const points = strands.points.length / 3;
  return (
    <div class="viewed" role="status">
      <p>{t(`ui.viewed.${on}`, { name, strands: strandCount(strands), points })}</p>
      <CommandButton command="hair.end-viewing" kind="primary" />
    </div>
  );
}
