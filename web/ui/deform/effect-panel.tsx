import { t, tCode } from '../../app/i18n';
import { useApp } from '../context';
import { CommandButton } from '../controls/command-button';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';

const signed = (value: number): string => `${value >= 0 ? '+' : '−'}${Math.abs(value * 100).toFixed(1)} %`;

/** What the edit did, in numbers. */
export function EffectPanel() {
  const { state } = useApp();
  const did = state.whatItDid.value;
  const warnings = state.warnings.value;
  if (!did && warnings.length === 0) return null;
  return (
    <Section title={t('ui.effect')} aside={<CommandButton command="view.heat" iconOnly />}>
      {did && (
        <dl class="figures">
          {did.closed && (
            <>
              <dt>{t('ui.effect.volume')}</dt>
              <dd>{signed(did.volumeRatio - 1)}</dd>
            </>
          )}
          <dt>{t('ui.effect.stretch')}</dt>
          <dd class={did.worstStretch > 1 ? 'warn' : ''}>{(did.worstStretch * 100).toFixed(0)} %</dd>
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
      {warnings.map((warning) => (
        <p key={warning.code} class="note warn">
          <Icon name="triangle-alert" />
          {tCode('finding.', warning.code, 'finding.unknown', { count: warning.count })}
        </p>
      ))}
    </Section>
  );
}
