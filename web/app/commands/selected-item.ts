import type { State } from '../state';

/** What commands of a wing ask of the selected item, by its number. */
export function selectedItem({ selection }: Pick<State, 'selection'>) {
  const index = (): number | null => selection.value.item;
  return {
    index,
    /** Whether there is one. */
    selected: () => index() !== null,
    /** Does something to it, where there is one. */
    onSelected: (act: (item: number) => void) => () => {
      const item = index();
      if (item !== null) act(item);
    },
    /** The one so many further, around the end; from none the first, or going back the last. */
    stepped: (by: number, count: number): number => ((index() ?? (by > 0 ? -1 : 0)) + by + count) % count,
  };
}
