import { t } from '../../app/i18n';
import type { WhatItDid } from '../../app/transfer/state';
import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { useTransfer } from './use-transfer';

/** What the pose did to the model, and where to go from here. */
export function ResultPanel() {
  const { figures, whatItDid } = useTransfer().state;
  if (!figures.value) return null;
  return (
    <Section title={t('ui.transfer.result')}>
      {whatItDid.value && <Figures did={whatItDid.value} />}
      <div class="buttons">
        <CommandButton command="transfer.deform" kind="solid" />
        <CommandButton command="transfer.another" kind="solid" />
      </div>
    </Section>
  );
}

const percent = (part: number): string => `${Number((100 * part).toFixed(1))} %`;

function Figures({ did: { volumeRatio, closed, edgeRms, flippedTriangles } }: { did: WhatItDid }) {
  return (
    <dl class="figures">
      {closed && (
        <>
          <dt>{t('ui.transfer.figure.volume')}</dt>
          <dd>{percent(volumeRatio)}</dd>
        </>
      )}
      <dt>{t('ui.transfer.figure.rms')}</dt>
      <dd>{percent(edgeRms)}</dd>
      <dt>{t('ui.transfer.figure.flipped')}</dt>
      <dd class={flippedTriangles === 0 ? 'good' : 'bad'}>{flippedTriangles}</dd>
    </dl>
  );
}
