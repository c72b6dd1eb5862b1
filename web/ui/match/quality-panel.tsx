import { t, tCode } from '../../app/i18n';
import { POSED_BY } from '../../app/match/models';
import type { Matching, PoorPlace, SkinQuality } from '../../app/match/result';
import { wings } from '../../app/wings';
import type { Finding } from '../../core/errors';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';
import { percent } from './percent';
import { useMatch } from './use-match';

const COUNTS = ['folds', 'crossings', 'flipped', 'sharp'] as const;

/** How good the skins are, and where another marker would help. */
export function QualityPanel() {
  const { state: own } = useMatch();
  const result = own.result.value;
  if (!result || own.growing.value) return null;
  return (
    <Section
      title={t('ui.match.quality')}
      aside={
        <>
          <CommandButton command="match.heat" iconOnly />
          <CommandButton command="match.edges" iconOnly />
        </>
      }
    >
      <Table result={result} />
      <p class="muted">
        {t('ui.match.figure.marker')} {percent(result.markerError)}
      </p>
      <Findings />
      <Poor result={result} />
    </Section>
  );
}

function Table({ result: { of, quality } }: { result: Matching }) {
  return (
    <table class="match-quality">
      <thead>
        <tr>
          <th scope="col">{t('ui.match.figure.distance')}</th>
          <th scope="col" title={t('ui.match.figure.mean.help')}>
            {t('ui.match.figure.mean')}
          </th>
          <th scope="col" title={t('ui.match.figure.p99.help')}>
            {t('ui.match.figure.p99')}
          </th>
        </tr>
      </thead>
      <tbody>
        {quality.map((each, at) => (
          <tr key={of.models[at]}>
            <th scope="row" title={of.models[at]}>
              {of.models[at]}
              <Faults quality={each} />
            </th>
            <td>{percent(each.mean)}</td>
            <td>{percent(each.p99)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** What should not be there, where there is any. */
function Faults({ quality }: { quality: SkinQuality }) {
  const found = COUNTS.filter((figure) => quality[figure] > 0);
  if (found.length === 0) return null;
  return (
    <span class="match-faults">
      {found.map((figure) => (
        <span key={figure} title={t(`ui.match.figure.${figure}.help`)}>
          {t(`ui.match.figure.${figure}`, { count: quality[figure] })}
        </span>
      ))}
    </span>
  );
}

/** Of what its pose is to blame for. */
const POSED = 'poses-differ';

/** What the match has to say, once for all models. */
function Findings() {
  const { state } = useApp();
  const codes = [...new Set(state.warnings.value.map(({ code }) => code))];
  return codes.map((code) => {
    const found = state.warnings.value.filter((each) => each.code === code);
    const count = found.reduce((sum, each) => sum + each.count, 0);
    const about = [...new Set(found.flatMap(({ model }) => model ?? []))];
    const note = (
      <p key={code} class="note warn">
        <Icon name="triangle-alert" />
        <span>
          {about.length > 0 && <strong>{about.join(', ')}: </strong>}
          {tCode('finding.', code, 'finding.unknown', { count, numbers: numbersOf(found) })}
        </span>
      </p>
    );
    if (code !== POSED) return note;
    return (
      <div key={code} class="match-posed">
        {note}
        {about.map((name) => (
          <PoseFirst key={name} name={name} />
        ))}
      </div>
    );
  });
}

/** Leads to where a model is posed before it is matched. */
function PoseFirst({ name }: { name: string }) {
  const { state: own, actions: match } = useMatch();
  const at = own.step.value?.models.indexOf(name) ?? -1;
  if (at < 0) return null;
  return (
    <div class="buttons">
      <span class="muted">{t('ui.match.pose.first', { name })}</span>
      {POSED_BY.map((by) => (
        <Button
          key={by}
          kind="solid"
          icon={wings[by].icon}
          label={t(`ui.match.pose.by.${by}`)}
          title={t(`ui.match.pose.${by}`)}
          onClick={() => match.pose(at, by)}
        />
      ))}
    </div>
  );
}

/** Markers by the numbers that they have on screen. */
const numbersOf = (found: readonly Finding[]): string =>
  found.flatMap(({ examples }) => examples.map((at) => at + 1)).join(', ');

function Poor({ result: { poor, of } }: { result: Matching }) {
  const { state: own, actions: match } = useMatch();
  if (poor.length === 0) return <p class="muted">{t('ui.match.poor.none')}</p>;
  const row = (place: PoorPlace) => (
    <li
      key={`${place.model} ${place.vertex}`}
      class={own.poor.value === place.vertex ? 'row selected' : 'row'}
    >
      <button
        type="button"
        class="row-main"
        aria-pressed={own.poor.value === place.vertex}
        onClick={() => match.showPoor(place)}
      >
        <Icon name="crosshair" />
        <span>{of.models[place.model]}</span>
        <span class="muted count">{percent(place.distance)}</span>
      </button>
    </li>
  );
  return (
    <>
      <h3 class="match-poor">{t('ui.match.poor')}</h3>
      <ul class="list" aria-label={t('ui.match.poor')}>
        {poor.map(row)}
      </ul>
    </>
  );
}
