import { formatNumber, t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Section } from '../controls/section';

export function ModelPanel() {
  const { state } = useApp();
  const facts = state.facts.value;
  if (!facts) return null;
  const findings = state.importReport.value?.findings ?? [];
  return (
    <Section title={t('ui.model')}>
      <p class="model-name">{facts.name}</p>
      <p class="muted">
        {facts.faces === 0
          ? t('ui.model.points', { points: facts.vertices })
          : t('ui.model.counts', { vertices: facts.vertices, faces: facts.faces })}
        {facts.faces > 0 && <br />}
        {facts.faces > 0 &&
          (facts.closed ? t('ui.model.closed') : t('ui.model.open', { loops: facts.boundaryLoops }))}
        {facts.components > 1 && ` · ${t('ui.model.parts', { count: formatNumber(facts.components) })}`}
      </p>
      {findings.length > 0 && (
        <Button
          kind="solid"
          icon={findings.every((finding) => finding.repaired) ? 'info' : 'triangle-alert'}
          label={t('ui.model.findings', { count: findings.length })}
          onClick={() => {
            state.dialog.value = 'import-report';
          }}
        />
      )}
    </Section>
  );
}
