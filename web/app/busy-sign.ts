import type { Signal } from '@preact/signals';
import type { Busy } from './state';

/** Work shorter than this shows no progress, in milliseconds. */
const PATIENCE = 250;

type Shown = Signal<Busy | null>;

/** What is going on and long enough to be shown, by the sign it is shown on; the newest last. */
const underWay = new WeakMap<Shown, Map<object, Busy>>();

/**
 * Shows progress once the work has taken long enough to be noticed. Work within other work covers its sign, and
 * uncovers it at its end.
 *
 * @param cancel  the way out
 */
export function busySign(busy: Shown, label: string, cancel: () => void) {
  const all = underWay.get(busy) ?? new Map<object, Busy>();
  underWay.set(busy, all);
  const self = {};
  let said = label;
  let fraction: number | null = null;
  let shown = false;
  const newest = () => [...all.values()].at(-1) ?? null;
  const show = () => {
    shown = true;
    all.set(self, { label: said, fraction, cancel });
    busy.value = newest();
  };
  const timer = setTimeout(show, PATIENCE);
  return {
    progress: (done: number) => {
      fraction = done;
      if (shown) show();
    },
    /** More of what is going on, in place of the label. */
    say: (more: string) => {
      said = more;
      if (shown) show();
    },
    end: () => {
      clearTimeout(timer);
      all.delete(self);
      if (shown) busy.value = newest();
    },
  };
}
