import { t } from '../../app/i18n';
import type { Pose } from '../../app/pose';
import { VectorField } from './fields';

interface Props {
  pose: Pose;
  /** Only moved: a point has no turn and no size. */
  moveOnly?: boolean;
  onChange: (change: Partial<Pose>) => void;
  onCommit: () => void;
}

/** Where a thing stands, as numbers: move, turn and size. */
export function PoseFields({ pose, moveOnly = false, onChange, onCommit }: Props) {
  return (
    <>
      <VectorField
        label={t('ui.pose.move')}
        value={pose.translation}
        step={0.01}
        digits={3}
        onChange={(translation) => onChange({ translation })}
        onCommit={onCommit}
      />
      {!moveOnly && (
        <>
          <VectorField
            label={t('ui.pose.turn')}
            title={t('ui.pose.turn.help')}
            value={pose.rotation}
            step={1}
            digits={1}
            onChange={(rotation) => onChange({ rotation })}
            onCommit={onCommit}
          />
          <VectorField
            label={t('ui.pose.size')}
            value={pose.scale}
            step={0.01}
            min={0.001}
            digits={3}
            onChange={(scale) => onChange({ scale })}
            onCommit={onCommit}
          />
        </>
      )}
    </>
  );
}
