import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';

/** Says what is on screen while a file is looked at in place of the document, and leads back. */
export function ViewedBar() {
  const viewing = useApp().state.viewing.value;
  if (!viewing) return null;
  return (
    <div class="viewed" role="status">
      <p>{viewing.said}</p>
      <CommandButton command={viewing.back} kind="primary" />
    </div>
  );
}
