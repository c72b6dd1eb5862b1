import { t } from '../../app/i18n';
import type { Pin } from '../../tools/merge/pins';
import { useApp } from '../context';

import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Icon } from '../controls/icon';
import { Section } from '../controls/section';
import { useMerge } from './use-merge';

/** Loops that are joined, and the pins that say which of their points meet. */
export function PairsPanel() {
  const { state: own, actions: merge } = useMerge();
  const step = own.step.value;
  if (!step || step.boundaries.length === 0) return null;
  const pins = merge.joins.pins();
  return (
    <Section title={t('ui.merge.pairs')} aside={<CommandButton command="tool.merge-pins" iconOnly />}>
      <ul class="list" aria-label={t('ui.merge.pairs')}>
        {step.boundaries.map((boundary, index) => (
          <li key={index}>
            <div class="row">
              <span class="row-main">
                <Icon name="link" />
                <span>{t('ui.merge.pair', { number: index + 1 })}</span>
                <span class="muted count">
                  {t('ui.merge.pair.sizes', {
                    source: boundary.source.length,
                    target: boundary.target.length,
                  })}
                </span>
              </span>
              <Button
                icon="trash-2"
                iconOnly
                label={t('ui.merge.pair.remove', { number: index + 1 })}
                onClick={() => merge.joins.removePair(index)}
              />
            </div>
            <Pins found={boundary.keys.length === 0} pins={pins.filter((pin) => pin.boundary === index)} />
          </li>
        ))}
      </ul>
    </Section>
  );
}

function Pins({ pins, found }: { pins: readonly Pin[]; found: boolean }) {
  const { state, document } = useApp();
  const selected = state.selection.value.item;
  return (
    <div class="pins">
      {pins.map(({ number }) => (
        <button
          key={number}
          type="button"
          class="pin"
          aria-label={t('ui.merge.pin', { number: number + 1 })}
          aria-pressed={number === selected}
          onClick={() => document.select(number === selected ? null : number)}
        >
          {number + 1}
        </button>
      ))}
      <span class="muted">{t(found ? 'ui.merge.pins.found' : 'ui.merge.pins.own')}</span>
    </div>
  );
}
