/** Where a link of a length can be pasted whole, narrowest first; `limit` in characters. */
export const LINK_PLACES = [
  { place: 'chat', limit: 2000 },
  { place: 'messages', limit: 4000 },
  { place: 'web', limit: 8000 },
  { place: 'address-bar', limit: 64_000 },
] as const;
