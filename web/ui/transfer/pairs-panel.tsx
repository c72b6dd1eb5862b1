import { t } from '../../app/i18n';
import type { PairRow } from '../../app/transfer/actions';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { useTransfer } from './use-transfer';

/** Each handle of the pose, and whether its counterpart is known. */
export function PairsPanel() {
  const { actions: transfer, state: own } = useTransfer();
  const through = own.step.value?.through;
  if (through !== undefined)
    return (
      <Section title={t('ui.transfer.pairs')}>
        <p class="muted">{t('ui.transfer.through', { name: through })}</p>
      </Section>
    );
  const rows = transfer.rows();
  if (rows.length === 0) return null;
  const paired = rows.length - transfer.open().length;
  return (
    <Section
      title={t('ui.transfer.pairs')}
      aside={<span class="muted">{t('ui.transfer.pairs.count', { paired, count: rows.length })}</span>}
    >
      <ul class="list" aria-label={t('ui.transfer.pairs')}>
        {rows.map((row) => (
          <Row key={row.index} row={row} />
        ))}
      </ul>
      <div class="buttons">
        <CommandButton command="transfer.by-name" kind="solid" />
      </div>
    </Section>
  );
}

function Row({ row: { index, name, isPoint, source, target } }: { row: PairRow }) {
  const { state } = useApp();
  const { actions: transfer } = useTransfer();
  const selected = state.selection.value.item === index;
  const open = source === 0 || target === 0;
  const size = isPoint ? t('ui.transfer.pair.point') : target;
  return (
    <li class={selected ? 'row selected' : 'row'}>
      <button type="button" class="row-main" aria-pressed={selected} onClick={() => transfer.pick(index)}>
        <span class={open ? 'pair-number open' : 'pair-number'}>{index + 1}</span>
        <span>{name}</span>
        <span class="muted count">{open ? t('ui.transfer.pair.none') : size}</span>
      </button>
      {target > 0 && (
        <Button
          icon="x"
          iconOnly
          label={t('ui.transfer.pair.clear', { name })}
          onClick={() => transfer.clear(index)}
        />
      )}
    </li>
  );
}
