// The gallery's hairstyles, each in a file of its own: strokes placed on the heads by geometry.

import { bob } from './hair/bob.mjs';
import { curly } from './hair/curly.mjs';
import { Hand } from './hair/hand.mjs';
import { parted } from './hair/parted.mjs';
import { pigtails } from './hair/pigtails.mjs';
import { ponytail } from './hair/ponytail.mjs';
import { sidePart } from './hair/side-part.mjs';
import { smooth } from './hair/smooth.mjs';
import { waves } from './hair/waves.mjs';
import { modelOf } from './models.mjs';

/** In the gallery's order. */
const STYLES = [smooth, parted, bob, ponytail, pigtails, curly, sidePart, waves];

const recipe = (head, style) => ({
  lissom: 1,
  models: { [head]: { builtin: head } },
  steps: [{ id: 'hair 1', type: 'hair', model: head, ...style }],
});

/** @returns name, title, model and recipe of each style */
export function hairExamples() {
  const hands = new Map();
  const handOn = (head) => {
    if (!hands.has(head)) hands.set(head, new Hand(modelOf(head)));
    return hands.get(head);
  };
  return STYLES.map(({ name, title, head, style }) => [name, title, head, recipe(head, style(handOn(head)))]);
}
