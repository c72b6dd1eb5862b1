import { heatGradient } from '../../view/heat';

/** What the colours on the model mean: lowest, middle, highest. */
export function Legend({ title, ends }: { title: string; ends: readonly [string, string, string] }) {
  return (
    <figure class="legend">
      <figcaption>{title}</figcaption>
      <div
        class="legend-bar"
        style={{ background: `linear-gradient(to right, ${heatGradient().join(', ')})` }}
      />
      <div class="legend-ends">
        {ends.map((end) => (
          <span key={end}>{end}</span>
        ))}
      </div>
    </figure>
  );
}
