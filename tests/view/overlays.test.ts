import { describe, expect, test } from 'vitest';
import { heatColour, heatGradient, heatTexels } from '../../web/view/heat';
import { polygonEdges } from '../../web/view/polygon-edges';
import { assignChannels, CHANNELS } from '../../web/view/region-channels';
import type { RegionPaint } from '../../web/view/types';

const luminance = ([r, g, b]: readonly number[]): number => 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;

describe('the heat map', () => {
  test('grows brighter from its lower end to the middle and darker from there, without a step back', () => {
    const light = Array.from({ length: 101 }, (_, i) => luminance(heatColour(i / 100)));
    for (let i = 1; i <= 50; i++) expect(light[i]!).toBeGreaterThan(light[i - 1]!);
    for (let i = 51; i <= 100; i++) expect(light[i]!).toBeLessThan(light[i - 1]!);
  });

  test('is blue below, red above, pale in the middle, and clamps', () => {
    const [cold, middle, warm] = [heatColour(0), heatColour(0.5), heatColour(1)];
    expect(cold[2]).toBeGreaterThan(2 * cold[0]);
    expect(warm[0]).toBeGreaterThan(2 * warm[2]);
    expect(Math.max(...middle) - Math.min(...middle)).toBeLessThan(0.06);
    expect(heatColour(-3)).toEqual(cold);
    expect(heatColour(7)).toEqual(warm);
  });

  test('has the same colours in the legend as in the texture', () => {
    const legend = heatGradient(256).map((css) => css.match(/\d+/g)!.map(Number));
    const texels = heatTexels(256);
    legend.forEach((rgb, i) => {
      expect(rgb).toEqual([...texels.subarray(4 * i, 4 * i + 3)]);
    });
  });
});

describe('the wireframe', () => {
  const edgesOf = (faces: readonly (readonly number[])[], count: number): string[] => {
    const offsets = [0];
    for (const face of faces) offsets.push(offsets.at(-1)! + face.length);
    const edges = polygonEdges(Uint32Array.from(offsets), Uint32Array.from(faces.flat()), count);
    return Array.from({ length: edges.length / 2 }, (_, e) => `${edges[2 * e]}-${edges[2 * e + 1]}`).sort();
  };

  test('shows a quad as four edges, and an edge of two faces once', () => {
    const faces = [
      [0, 1, 2, 3],
      [3, 2, 4],
    ];
    expect(edgesOf(faces, 5)).toEqual(['0-1', '0-3', '1-2', '2-3', '2-4', '3-4']);
  });

  test('passes over repeated corners and vertices that are not there', () => {
    expect(edgesOf([[0, 0, 1, 9]], 2)).toEqual(['0-1']);
  });
});

describe('region channels', () => {
  const region = (id: string, more: Partial<RegionPaint> = {}): RegionPaint => ({
    id,
    kind: 'handle',
    vertices: Uint32Array.of(1),
    visible: true,
    selected: false,
    ...more,
  });
  const ids = (channels: ReturnType<typeof assignChannels>): string[] =>
    channels.map((channel) => channel.regions.map(({ id }) => id).join());

  test('lie with the region of interest below and the selected handle on top', () => {
    const regions = [region('a', { selected: true }), region('b'), region('r', { kind: 'roi' })];
    expect(ids(assignChannels(regions, () => false))).toEqual(['r', 'b', 'a']);
  });

  test('are shared by handles that do not touch, and apart for those that do', () => {
    const regions = ['a', 'b', 'c'].map((id) => region(id));
    const touching = (x: RegionPaint, y: RegionPaint): boolean => [x.id, y.id].sort().join() === 'a,b';
    expect(ids(assignChannels(regions, touching))).toEqual(['a,c', 'b']);
  });

  test('never number more than the card is given, and every visible region has one', () => {
    const kinds = ['roi', 'handle', 'source', 'feature', 'target', 'scalp'] as const;
    const regions = Array.from({ length: 40 }, (_, i) =>
      region(`${i}`, { kind: kinds[i % 3]!, selected: i % 7 === 0 }),
    );
    const channels = assignChannels(regions, () => true);
    expect(channels.length).toBeLessThanOrEqual(CHANNELS);
    expect(channels.flatMap((channel) => channel.regions)).toHaveLength(40);
  });

  test('are not spent on what is hidden or empty', () => {
    const regions = [region('a', { visible: false }), region('b', { vertices: new Uint32Array() })];
    expect(assignChannels(regions, () => false)).toEqual([]);
  });
});
