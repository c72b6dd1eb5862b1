import { Fragment } from 'preact';
import { t } from '../../app/i18n';
import { linkOf } from '../../recipe/steps/curves-edits';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Segments } from '../controls/fields';
import { Section } from '../controls/section';
import { useCurves } from './use-curves';

const ENDS = ['start', 'end'] as const;

/** The selected curve: what it is, which end stays, where it ends. */
export function CurvePanel() {
  const { state: own, actions: curves } = useCurves();
  const curve = curves.curve();
  const step = own.step.value;
  if (!curve || !step || curve.kind === 'contour') return null;
  const { id, kind, rest, rigid = [], anchor } = curve;
  const parent = linkOf(step, id)?.parent;
  return (
    <Section title={id}>
      <Segments
        label={t('ui.curves.kind')}
        value={kind}
        options={(['skeleton', 'surface'] as const).map((value) => ({
          value,
          label: t(`ui.curves.kind.${value}`),
        }))}
        onChange={(value) => curves.setKind(id, value)}
      />
      <div class="field">
        <span class="label" title={t('ui.curves.anchor.help')}>
          {t('ui.curves.anchor')}
        </span>
        <Segments
          label={t('ui.curves.anchor')}
          value={anchor ?? 'auto'}
          options={(['auto', ...ENDS] as const).map((value) => ({
            value,
            label: t(`ui.curves.anchor.${value}`),
          }))}
          onChange={(value) => curves.setAnchor(id, value === 'auto' ? undefined : value)}
        />
      </div>
      <div class="field">
        <span class="label" title={t('ui.curves.rigid.help')}>
          {t('ui.curves.rigid')}
        </span>
        <fieldset class="curve-segments" aria-label={t('ui.curves.rigid')}>
          {rest.slice(1).map((_, segment) => (
            <Button
              key={segment}
              label={t('ui.curves.rigid.segment', { number: segment + 1 })}
              short={String(segment + 1)}
              pressed={rigid.includes(segment)}
              onClick={() => curves.toggleRigid(id, segment)}
            />
          ))}
        </fieldset>
      </div>
      <div class="curve-ends">
        {ENDS.map((end) => (
          <Fragment key={end}>
            <span>{t(`ui.curves.end.${end}`)}</span>
            <Button
              icon="minus"
              iconOnly
              label={t(`ui.curves.end.${end}.shorter`)}
              onClick={() => curves.moveEnd(end, true)}
            />
            <Button
              icon="plus"
              iconOnly
              label={t(`ui.curves.end.${end}.longer`)}
              onClick={() => curves.moveEnd(end, false)}
            />
          </Fragment>
        ))}
      </div>
      <div class="buttons">
        <CommandButton command="curves.mirror" kind="solid" />
        <CommandButton command="curves.reset" kind="solid" />
        {parent && (
          <Button
            icon="unlink"
            kind="solid"
            label={t('ui.curves.unlink', { name: parent })}
            onClick={() => curves.unlink(id)}
          />
        )}
      </div>
    </Section>
  );
}
