import { signal } from '@preact/signals';
import { expect, test } from 'vitest';
import type { Evaluation } from '../../web/app/evaluated';
import { type Moving, syncMotion } from '../../web/app/motion-sync';
import type { MotionPort, MotionTable } from '../../web/view/motion/types';
import type { ViewportPort } from '../../web/view/types';

/** A card that holds motions of so many vertices. */
function cardOf(most: number) {
  const moves: (MotionTable | null)[] = [];
  const port: MotionPort = {
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
    moved: vertices === null ? null : { motion: { vertexCount: vertices }, table },
  }) as unknown as Evaluation;

test('a motion that is too much for the card is moved otherwise, and the next model is tried again', () => {
  const { viewport, moves } = cardOf(100);
  const result = signal<Evaluation | null>(null);
  const own: Moving = { movable: signal(false), readBack: () => null };
  const stop = syncMotion(viewport, { result }, own);
  expect(own.movable.value).toBe(true);
  const [large, small] = [{}, {}];
  result.value = evaluated(large, 1000);
  expect(own.movable.value).toBe(false);
  result.value = evaluated(large, null);
  expect(own.movable.value).toBe(false);
  result.value = evaluated(small, null);
  expect(own.movable.value).toBe(true);
  moves.length = 0;
  result.value = evaluated(small, 10);
  expect(own.movable.value).toBe(true);
  expect(moves).toEqual([table]);
  stop();
  expect(own.movable.value).toBe(false);
});
