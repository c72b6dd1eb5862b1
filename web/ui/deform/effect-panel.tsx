import { t } from '../../app/i18n';
import { useApp } from '../context';

import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { Warnings } from '../shell/warnings';
import { useDeform } from './use-deform';

/** `+31 %`, `−40 %`, and plain `0 %` for what did not change. */
function signed(value: number, digits: number): string {
  const percent = (Math.abs(value) * 100).toFixed(digits);
  const sign = Number(percent) === 0 ? '' : value > 0 ? '+' : '−';
  return `${sign}${percent} %`;
}

/** Edges beyond these lengths have lost their triangles' shape. */
const isStrained = (stretch: number): boolean => stretch > 1 || stretch < -0.5;

/** What the edit did, in numbers. */
export function EffectPanel() {
  const { state } = useApp();
  const { state: own } = useDeform();
  const did = own.whatItDid.value;
  const warnings = state.warnings.value;
  if (!did && warnings.length === 0) return null;
  return (
    <Section title={t('ui.effect')} aside={<CommandButton command="view.heat" iconOnly />}>
      {did && (
        <dl class="figures">
          {did.closed && (
            <>
              <dt>{t('ui.effect.volume')}</dt>
              <dd>{signed(did.volumeRatio - 1, 1)}</dd>
            </>
          )}
          <dt>{t('ui.effect.stretch')}</dt>
          <dd class={isStrained(did.worstStretch) ? 'warn' : ''}>{signed(did.worstStretch, 0)}</dd>
          <dt>{t('ui.effect.rms')}</dt>
          <dd>{(did.edgeRms * 100).toFixed(1)} %</dd>
          <dt>{t('ui.effect.met')}</dt>
          <dd>{t('ui.effect.met.of', { met: did.handlesMet, count: did.handles })}</dd>
          {did.flippedTriangles > 0 && (
            <>
              <dt>{t('ui.effect.flipped')}</dt>
              <dd class="warn">{did.flippedTriangles}</dd>
            </>
          )}
        </dl>
      )}
      <Warnings />
    </Section>
  );
}
