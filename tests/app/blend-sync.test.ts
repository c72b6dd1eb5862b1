import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import { type Blending, syncBlend } from '../../web/app/blend-sync';
import type { Evaluation } from '../../web/app/evaluated';
import type { BlendPort, MotionTable } from '../../web/view/blend/types';
import type { ViewportPort } from '../../web/view/types';

/** A card that holds motions of so many vertices. */
function cardOf(most: number) {
  const moves: (MotionTable | null)[] = [];
  const port: BlendPort = {
    setMotion: (motion) => motion !== null && motion.vertexCount <= most,
    move: (table) => void moves.push(table),
    arrive: () => void moves.push(null),
    readBack: () => null,
  };
  const viewport = { mount: () => ({ port, unmount: () => {} }) } as unknown as ViewportPort;
  return { viewport, moves };
}

const table = new Float64Array(12);

/** What of an evaluation the card is told. */
const evaluated = (opened: object, vertices: number | null): Evaluation =>
  ({
    shown: { opened },
    blend: vertices === null ? null : { motion: { vertexCount: vertices }, table },
  }) as unknown as Evaluation;

test('a motion that is too much for the card is moved otherwise, and the next model is tried again', () => {
  const { viewport, moves } = cardOf(100);
  const result = signal<Evaluation | null>(null);
  const own: Blending = { blends: signal(false), readBack: () => null };
  const stop = syncBlend(viewport, { result }, own);
  expect(own.blends.value).toBe(true);
  const [large, small] = [{}, {}];
  result.value = evaluated(large, 1000);
  expect(own.blends.value).toBe(false);
  result.value = evaluated(large, null);
  expect(own.blends.value).toBe(false);
  result.value = evaluated(small, null);
  expect(own.blends.value).toBe(true);
  moves.length = 0;
  result.value = evaluated(small, 10);
  expect(own.blends.value).toBe(true);
  expect(moves).toEqual([table]);
  stop();
  expect(own.blends.value).toBe(false);
});
