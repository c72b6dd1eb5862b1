import { useApp } from '../context';

import { PoseFields } from '../controls/pose-fields';
import { Section } from '../controls/section';
import { useDeform } from './use-deform';

/** The selected handle's move, turn and size as numbers. */
export function PosePanel() {
  const { state } = useApp();
  const { state: own, actions: deform } = useDeform();
  const index = state.selection.value.item;
  const handle = index === null ? undefined : own.step.value?.handles[index];
  const pose = index === null ? undefined : deform.pose(index);
  if (index === null || !handle || !pose) return null;
  return (
    <Section title={deform.handleName(index)}>
      <PoseFields
        pose={pose}
        moveOnly={handle.kind === 'point'}
        onChange={(change) => deform.setPose(index, change, true)}
        onCommit={() => deform.finish()}
      />
    </Section>
  );
}
