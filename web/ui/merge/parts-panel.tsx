import { t } from '../../app/i18n';
import type { MergeSide } from '../../tools/merge/pins';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { useMerge } from './use-merge';

/** The two models. */
export function PartsPanel() {
  const { state } = useApp();
  return (
    <Section
      title={t('ui.merge.models')}
      aside={!state.choosing.value && <CommandButton command="merge.part" iconOnly />}
    >
      <Model side="source" />
      <Model side="target" />
    </Section>
  );
}

function Model({ side }: { side: MergeSide }) {
  const shown = useMerge().state.sides.value[side];
  return (
    <div class="merge-model">
      <span class={`dot ${side}`} />
      <span class="muted">{t(`ui.merge.${side}`)}</span>
      <span class="model-name">{shown?.model.name ?? '—'}</span>
      <span class="muted count">
        {shown && t('ui.figure.vertices', { count: shown.model.positions.length / 3 })}
      </span>
    </div>
  );
}
