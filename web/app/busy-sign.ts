import type { Signal } from '@preact/signals';
import type { Busy } from './state';

/** Work shorter than this shows no progress, in milliseconds. */
const PATIENCE = 250;

/** Shows progress once the work has taken long enough to be noticed. @param cancel  the way out */
export function busySign(busy: Signal<Busy | null>, label: string, cancel: () => void) {
  let fraction: number | null = null;
  let shown = false;
  const show = () => {
    shown = true;
    busy.value = { label, fraction, cancel };
  };
  const timer = setTimeout(show, PATIENCE);
  return {
    progress: (done: number) => {
      fraction = done;
      if (shown) show();
    },
    end: () => {
      clearTimeout(timer);
      if (shown) busy.value = null;
    },
  };
}
