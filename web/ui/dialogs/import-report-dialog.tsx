import { t, tCode } from '../../app/i18n';
import { useApp } from '../context';
import { Dialog } from '../controls/dialog';
import { Icon } from '../controls/icon';

/** One line a finding: what the file had, and what was done about it. */
export function ImportReportDialog({ onClose }: { onClose: () => void }) {
  const report = useApp().state.importReport.value;
  return (
    <Dialog title={t('ui.report')} closeLabel={t('ui.close')} onClose={onClose}>
      {report && (
        <>
          <p>
            <strong>{report.file}</strong>{' '}
            <span class="muted">
              {t('ui.model.counts', { vertices: report.facts.vertices, faces: report.facts.faces })}
            </span>
          </p>
          {report.findings.length === 0 && <p>{t('ui.report.clean')}</p>}
          <ul class="findings">
            {report.findings.map((finding) => (
              <li key={finding.code}>
                <span class={finding.repaired ? 'good' : 'warn'}>
                  <Icon name={finding.repaired ? 'check' : 'info'} />
                </span>
                <span>
                  {tCode('finding.', finding.code, 'finding.unknown', { count: finding.count })}
                  {finding.examples.length > 0 && (
                    <span class="muted"> {t('ui.report.where', { list: finding.examples.join(', ') })}</span>
                  )}
                </span>
              </li>
            ))}
          </ul>
          <p class="muted">{t('ui.report.kept')}</p>
        </>
      )}
    </Dialog>
  );
}
