import { heatGradient } from '../../view/heat';

interface Props {
  title: string;
  ends: readonly [string, string, string];
  /** From left to right; the whole heat map where left out. */
  colours?: readonly string[];
}

/** What the colours on the model mean: lowest, middle, highest. */
export function Legend({ title, ends, colours = heatGradient() }: Props) {
  return (
    <figure class="legend">
      <figcaption>{title}</figcaption>
      <div class="legend-bar" style={{ background: `linear-gradient(to right, ${colours.join(', ')})` }} />
      <div class="legend-ends">
        {ends.map((end) => (
          <span key={end}>{end}</span>
        ))}
      </div>
    </figure>
  );
}
