import { describe, expect, test } from 'vitest';
import { assignChannels, CHANNELS } from '../../web/view/region-channels';
import type { RegionPaint } from '../../web/view/types';

describe('region channels', () => {
  const region = (id: string, more: Partial<RegionPaint> = {}): RegionPaint => ({
    id,
    tint: 'violet',
    vertices: Uint32Array.of(1),
    visible: true,
    selected: false,
    ...more,
  });
  const ids = (channels: ReturnType<typeof assignChannels>): string[] =>
    channels.map((channel) => channel.regions.map(({ id }) => id).join());

  test('lie with the region of interest below and the selected handle on top', () => {
    const regions = [region('a', { selected: true }), region('b'), region('r', { tint: 'blue' })];
    expect(ids(assignChannels(regions, () => false))).toEqual(['r', 'b', 'a']);
  });

  test('are shared by handles that do not touch, and apart for those that do', () => {
    const regions = ['a', 'b', 'c'].map((id) => region(id));
    const touching = (x: RegionPaint, y: RegionPaint): boolean => [x.id, y.id].sort().join() === 'a,b';
    expect(ids(assignChannels(regions, touching))).toEqual(['a,c', 'b']);
  });

  test('never number more than the card is given, and every visible region has one', () => {
    const tints = ['blue', 'violet', 'red'] as const;
    const regions = Array.from({ length: 40 }, (_, i) =>
      region(`${i}`, { tint: tints[i % 3]!, selected: i % 7 === 0 }),
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
