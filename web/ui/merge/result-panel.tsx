import { t } from '../../app/i18n';
import type { MergeFigures } from '../../app/merge/state';

import { CommandButton } from '../controls/command-button';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';
import { Warnings } from '../shell/warnings';
import { EnergyCurve } from './energy-curve';
import { useMerge } from './use-merge';

/** What came of the merge, or why there is none. */
export function ResultPanel() {
  const { state: own } = useMerge();
  const { problem, figures } = own;
  if (!problem.value && !figures.value) return null;
  return (
    <Section title={t('ui.merge.result')} aside={<CommandButton command="merge.before" iconOnly />}>
      {problem.value && (
        <p class="note warn">
          <Icon name="triangle-alert" />
          {problem.value}
        </p>
      )}
      {figures.value && <Figures figures={figures.value} />}
      <Warnings />
    </Section>
  );
}

function Figures({ figures }: { figures: MergeFigures }) {
  return (
    <>
      <dl class="figures">
        <dt>{t('ui.merge.figure.seam')}</dt>
        <dd>{figures.seamVertices}</dd>
        <dt>{t('ui.merge.figure.closed')}</dt>
        <dd class={figures.closed ? 'good' : ''}>
          {t(figures.closed ? 'ui.merge.figure.closed.yes' : 'ui.merge.figure.closed.no')}
        </dd>
        <dt title={t('ui.merge.figure.euler.help')}>{t('ui.merge.figure.euler')}</dt>
        <dd>{figures.eulerCharacteristic}</dd>
        <dt title={t('ui.merge.figure.dihedral.help')}>{t('ui.merge.figure.dihedral')}</dt>
        <dd>
          {t('ui.merge.figure.dihedral.of', {
            seam: Number(figures.seamDihedral.toFixed(1)),
            own: Number(figures.ownDihedral.toFixed(1)),
          })}
        </dd>
      </dl>
      {figures.energy.length > 1 && <EnergyCurve energy={figures.energy} />}
      <div class="buttons">
        <CommandButton command="merge.deform" kind="solid" />
        <CommandButton command="merge.another" kind="solid" />
      </div>
    </>
  );
}
