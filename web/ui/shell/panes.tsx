import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { useApp } from '../context';
import './panes.css';

interface Props {
  /** Number of the pane, from 0. */
  index: number;
  class?: string;
  children?: ComponentChildren;
}

/** One of the models side by side: its viewport, and what floats over it. */
export function Pane({ index, class: name = '', children }: Props) {
  const { panes } = useApp();
  const frame = panes.all.value[index]?.frame;
  const holder = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (frame) holder.current?.prepend(frame);
  }, [frame]);
  return (
    <div ref={holder} class={`pane ${name}`}>
      {children}
    </div>
  );
}
