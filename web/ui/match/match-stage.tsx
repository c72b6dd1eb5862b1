import { t } from '../../app/i18n';
import { LOOKS } from '../../app/match/state';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Segments } from '../controls/fields';
import { ModelChooser } from '../shell/model-chooser';
import { Pane } from '../shell/panes';
import { type Cell, gridOf, placeOf } from './grid';
import { MarkerOverlay } from './marker-overlay';
import { useMatch } from './use-match';

/** The models side by side: the first in the main viewport, each other in a pane. */
export function MatchStage() {
  const { state: own, actions: match } = useMatch();
  const models = own.models.value;
  const asked = match.models.asked();
  const count = Math.max(models.length, (asked ?? 0) + 1, 1);
  const grid = gridOf(count);
  return (
    <>
      {Array.from({ length: count }, (_, at) => {
        const cell = placeOf(grid, at);
        const inside = asked === at ? <Chooser /> : <Model at={at} />;
        if (at === 0)
          return (
            <div key={at} class={cellClass(at, grid, asked)} style={cell}>
              {inside}
            </div>
          );
        return (
          <div key={at} class={cellClass(at, grid, asked)} style={cell}>
            <Pane index={at - 1} class="match-pane" />
            {inside}
          </div>
        );
      })}
    </>
  );
}

/** The main viewport takes its size from the first one's class. */
function cellClass(at: number, { columns, rows }: Cell, asked: number | null): string {
  const size = at === 0 ? ` first columns-${columns} rows-${rows}` : '';
  return `match-cell${size}${asked === at ? ' choosing' : ''}`;
}

function Chooser() {
  const { actions: match } = useMatch();
  const held = match.models.held();
  return (
    <ModelChooser
      title={t('ui.match.choose')}
      help={t('ui.match.choose.help')}
      onCancel={() => match.models.cancel()}
    >
      {held.length > 0 && (
        <div class="match-held">
          <span class="muted">{t('ui.match.choose.held')}</span>
          {held.map((name) => (
            <Button
              key={name}
              kind="solid"
              icon="box"
              label={name}
              onClick={() => match.models.takeHeld(name)}
            />
          ))}
        </div>
      )}
    </ModelChooser>
  );
}

/** What lies over a model: its name, its markers, what is asked of it, what it shows. */
function Model({ at }: { at: number }) {
  const { state, viewport, panes } = useApp();
  const { state: own, actions: match } = useMatch();
  const shown = own.models.value[at];
  if (!shown) return null;
  const step = own.step.value;
  const name = step?.models[at] ?? shown.model.name;
  const choosing = state.choosing.value !== null;
  const view = at === 0 ? viewport : panes.all.value[at - 1]?.viewport;
  const isNext = !choosing && match.marking.nextModel() === at;
  return (
    <>
      {step && !choosing && <MarkerOverlay view={view} at={at} />}
      {isNext && <span class="match-next" />}
      <p class="pane-label">
        <span class="match-number">{at + 1}</span>
        <span class="match-name">{name}</span>
      </p>
      <div class="match-foot">
        {!choosing && <Hint at={at} />}
        {own.skinOf(at) && !own.growing.value && !choosing && (
          <Segments
            label={t('ui.match.look', { name })}
            value={own.lookOf(at)}
            options={LOOKS.map((value) => ({ value, label: t(`ui.match.look.${value}`) }))}
            onChange={(look) => match.look(at, look)}
          />
        )}
      </div>
    </>
  );
}

/** The next thing to do on a model, if it is this one's turn. */
function Hint({ at }: { at: number }) {
  const { state } = useApp();
  const { state: own, actions: match } = useMatch();
  const step = own.step.value;
  if (!step || own.running.value) return null;
  const { marker, curve } = { marker: own.marker.value, curve: own.curve.value };
  if (match.marking.nextModel() === at) {
    if (curve !== null) return <p class="hint">{t('ui.match.hint.curve', { number: curve + 1 })}</p>;
    const suggested = match.marking.next() !== undefined;
    return (
      <p class={suggested ? 'hint match-suggested' : 'hint'}>
        {t('ui.match.hint.mark', { number: marker! + 1 })}
        {suggested && (
          <Button kind="solid" label={t('ui.match.accept')} onClick={() => match.marking.accept()} />
        )}
      </p>
    );
  }
  const isBlank = step.markers.length === 0 && !own.result.value;
  return at === 0 && isBlank && state.tool.value === 'match-marker' ? (
    <p class="hint">{t('ui.match.hint.first')}</p>
  ) : null;
}
