import { t } from '../../app/i18n';
import { MARKS } from '../../app/merge/steps';
import type { Mark } from '../../tools/merge/host';

import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Section } from '../controls/section';
import { useMerge } from './use-merge';

/** Where the two shall meet, roughly painted; and the button that does it. */
export function MarksPanel() {
  const { state: own } = useMerge();
  const step = own.step.value;
  if (!step) return null;
  const waits = own.isHeld(step) || !own.figures.value;
  return (
    <Section title={t('ui.merge.marks')} aside={<CommandButton command="tool.mark-region" iconOnly />}>
      {step.boundaries.length > 0 ? (
        <p class="muted">{t('ui.merge.joined')}</p>
      ) : (
        <ul class="list">
          {MARKS.map((mark) => (
            <MarkRow key={mark} mark={mark} />
          ))}
        </ul>
      )}
      {(step.boundaries.length === 0 || waits) && (
        <div class="merge-go">
          <CommandButton command="merge.run" kind={waits ? 'primary' : 'solid'} />
        </div>
      )}
      {step.boundaries.length === 0 && <CommandButton command="merge.cut" kind="solid" />}
    </Section>
  );
}

function MarkRow({ mark }: { mark: Mark }) {
  const { actions: merge } = useMerge();
  const size = merge.marking.markSize(mark);
  const name = t(`ui.merge.mark.${mark}`);
  return (
    <li class="row" title={t(`ui.merge.mark.${mark}.help`)}>
      <span class="row-main">
        <span class={`dot ${mark}`} />
        <span>{name}</span>
        <span class="muted count">
          {size > 0 ? size : t(mark === 'feature' ? 'ui.merge.mark.found' : 'ui.merge.mark.none')}
        </span>
      </span>
      {size > 0 && (
        <Button
          icon="x"
          iconOnly
          label={t('ui.merge.mark.clear', { name })}
          onClick={() => merge.marking.clearMark(mark)}
        />
      )}
    </li>
  );
}
