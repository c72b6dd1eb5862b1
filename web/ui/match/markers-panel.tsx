import { t } from '../../app/i18n';
import { lacking } from '../../app/match/evaluation';
import { curveItem, type SharpRow, sharpItem } from '../../app/match/state';
import { isEmpty } from '../../core/vertex-set';
import { missing } from '../../tools/match/edits';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';
import { useMatch } from './use-match';

/** What belongs together; and the button that matches it. */
export function MarkersPanel() {
  const { state: own, actions: match } = useMatch();
  const step = own.step.value;
  if (!step) return null;
  const { markers, curves = [] } = step;
  const { whole } = match.marking.counts();
  const lacks = lacking(step);
  return (
    <Section
      title={t('ui.match.markers')}
      aside={<span class="muted">{markers.length > 0 ? `${whole} / ${markers.length}` : ''}</span>}
    >
      {markers.length + curves.length === 0 && <p class="muted">{t('ui.match.markers.none')}</p>}
      {markers.length + curves.length > 0 && (
        <ul class="list match-markers" aria-label={t('ui.match.markers')}>
          {markers.map((_, marker) => (
            <MarkerRow key={marker} marker={marker} />
          ))}
          {curves.map((_, curve) => (
            <CurveRow key={curveItem(curve)} curve={curve} />
          ))}
        </ul>
      )}
      <SharpRows />
      <Masks />
      {lacks > 0 && <p class="muted">{t('ui.match.hint.count', { count: lacks })}</p>}
      <Run />
    </Section>
  );
}

/** The one thing to press. */
function Run() {
  const { state: own } = useMatch();
  const problem = own.problem.value;
  const outdated = own.outdated.value && !own.running.value;
  return (
    <div class="match-go">
      {problem && (
        <p class="note warn" role="alert">
          <Icon name="triangle-alert" />
          {problem}
        </p>
      )}
      {outdated && (
        <p class="note match-outdated">
          <Icon name="history" />
          {t('ui.match.again')}
        </p>
      )}
      <CommandButton command={own.result.value ? 'match.again' : 'match.run'} kind="primary" />
    </div>
  );
}

function MarkerRow({ marker }: { marker: number }) {
  const { state: own, actions: match } = useMatch();
  const step = own.step.value!;
  const open = missing(step.markers[marker] ?? []);
  const name = t('ui.match.marker', { number: marker + 1 });
  const lost = open.length === 0 && own.models.value.some((_, at) => !match.marking.points(at)[marker]);
  return (
    <ItemRow
      item={marker}
      number={String(marker + 1)}
      name={name}
      open={open.length > 0}
      note={
        lost
          ? t('ui.match.marker.lost')
          : open.length > 0
            ? t('ui.match.marker.missing', { name: step.models[open[0]!]! })
            : ''
      }
    />
  );
}

function CurveRow({ curve }: { curve: number }) {
  const step = useMatch().state.step.value!;
  const rows = step.curves?.[curve] ?? [];
  const drawn = rows.filter(({ length }) => length > 1).length;
  const open = drawn < rows.length;
  return (
    <ItemRow
      item={curveItem(curve)}
      number="~"
      name={t('ui.match.curve', { number: curve + 1 })}
      open={open}
      note={open ? t('ui.match.curve.rest', { count: drawn, all: rows.length }) : ''}
    />
  );
}

/** Edges that were picked to stay sharp, model by model. */
function SharpRows() {
  const step = useMatch().state.step.value;
  const rows = (step?.sharp ?? []).flatMap((held, model) => held.map((_, row) => ({ model, row })));
  if (!step || rows.length === 0) return null;
  return (
    <ul class="list match-markers" aria-label={t('ui.match.edges')}>
      {rows.map((each) => (
        <SharpItem key={sharpItem(each)} {...each} />
      ))}
    </ul>
  );
}

function SharpItem({ model, row }: SharpRow) {
  const { state: own } = useMatch();
  const step = own.step.value!;
  const vertices = step.sharp?.[model]?.[row] ?? [];
  const count = (own.models.value[model]?.model.positions.length ?? Number.POSITIVE_INFINITY) / 3;
  const lost = vertices.some((v) => v >= count);
  return (
    <ItemRow
      item={sharpItem({ model, row })}
      number="∠"
      name={t('ui.match.edge', { number: row + 1 })}
      open={lost}
      note={lost ? t('ui.match.marker.lost') : step.models[model]!}
    />
  );
}

interface ItemProps {
  item: number;
  number: string;
  name: string;
  /** It is not on every model yet. */
  open: boolean;
  note: string;
}

function ItemRow({ item, number, name, open, note }: ItemProps) {
  const { state } = useApp();
  const { actions: match } = useMatch();
  const selected = state.selection.value.item === item;
  return (
    <li class={selected ? 'row selected' : 'row'}>
      <button type="button" class="row-main" aria-pressed={selected} onClick={() => match.pick(item)}>
        <span class={open ? 'match-number open' : 'match-number'}>{number}</span>
        <span>{name}</span>
        <span class="muted count">{note}</span>
      </button>
      <Button
        icon="x"
        iconOnly
        label={t('ui.match.remove', { name })}
        onClick={() => match.marking.remove(item)}
      />
    </li>
  );
}

/** What is not to be matched, where there is any. */
function Masks() {
  const { state: own, actions: match } = useMatch();
  const step = own.step.value;
  const masked = (step?.mask ?? []).flatMap((set, at) => (isEmpty(set) ? [] : [at]));
  if (!step || masked.length === 0) return null;
  return (
    <ul class="list" aria-label={t('ui.match.masks')}>
      {masked.map((at) => (
        <li key={at} class="row">
          <span class="row-main">
            <span class="dot masked" />
            <span>{t('ui.match.masks')}</span>
            <span class="muted count">{step.models[at]}</span>
          </span>
          <Button
            icon="x"
            iconOnly
            label={t('ui.match.mask.clear', { name: step.models[at]! })}
            onClick={() => match.marking.setMask('clear', at, new Uint32Array())}
          />
        </li>
      ))}
    </ul>
  );
}
