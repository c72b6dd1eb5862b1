// Painted regions go to the graphics card as a few 0–1 fields per vertex, "channels". Regions of one look
// share a channel as long as they do not touch, so that a border is seen where they do.

import { TINTS, type Tint } from './palette';
import type { RegionPaint } from './values';

export const CHANNELS = 8;

export interface Channel {
  readonly tint: Tint;
  readonly selected: boolean;
  readonly regions: readonly RegionPaint[];
}

/**
 * At most `CHANNELS` channels, lowest first. With more groups than that, the last one of a look takes what
 * is left over, and the regions in it may run together.
 */
export function assignChannels(
  regions: readonly RegionPaint[],
  touching: (a: RegionPaint, b: RegionPaint) => boolean,
): Channel[] {
  const seen = regions.filter((region) => region.visible && region.vertices.length > 0);
  const looks = new Map<number, RegionPaint[]>();
  for (const region of seen) {
    const look = 2 * TINTS.indexOf(region.tint) + Number(region.selected);
    looks.set(look, [...(looks.get(look) ?? []), region]);
  }
  const keys = [...looks.keys()].sort((a, b) => a - b);
  const channels: { tint: Tint; selected: boolean; regions: RegionPaint[] }[] = [];
  keys.forEach((key, index) => {
    const first = channels.length;
    const limit = CHANNELS - (keys.length - 1 - index);
    for (const region of looks.get(key)!) {
      const own = channels.slice(first);
      const free = own.find((channel) => !channel.regions.some((other) => touching(region, other)));
      if (free) free.regions.push(region);
      else if (channels.length < limit) {
        channels.push({ tint: region.tint, selected: region.selected, regions: [region] });
      } else channels.at(-1)!.regions.push(region);
    }
  });
  return channels.slice(0, CHANNELS);
}
