import { tCode } from '../../app/i18n';
import { useApp } from '../context';
import { Icon } from '../controls/icon';

/** What the open step has to say about what it was given. */
export function Warnings() {
  return useApp().state.warnings.value.map((warning) => (
    <p key={warning.code} class="note warn">
      <Icon name="triangle-alert" />
      {tCode('finding.', warning.code, 'finding.unknown', { count: warning.count })}
    </p>
  ));
}
