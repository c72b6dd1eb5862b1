// Garments on bodies that were matched, not given as corresponding: eighteen ordered pairs, measured against what was designed
// for each body. The shared models are for tests alone; without them this is skipped.

import { existsSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { type Model, vertexCount } from '../../web/core/model';
import { readModel } from '../../web/io/formats';
import { loadKernel } from '../../web/kernel/node';
import { parseRecipe } from '../../web/recipe/parse';
import { Runner } from '../../web/run/evaluate';
import type { StepResult } from '../../web/run/results';

const FOLDER = new URL('../../../shared/data/human/', import.meta.url);
const BODIES = ['female', 'male', 'heavy'] as const;
const GARMENTS = ['shirt', 'pants', 'skirt'] as const;
const MARKS = [
  ...['crown', 'nose_tip', 'chin', 'nape', 'navel', 'crotch'],
  ...['finger3', 'toe3', 'heel', 'knee', 'elbow', 'shoulder', 'hip'].flatMap((name) => [
    `${name}_l`,
    `${name}_r`,
  ]),
];
/** Mean distance from what was designed, in metres: whole, and along the cloth's normal. */
const MOST = {
  shirt: { all: 0.03, normal: 0.0035 },
  pants: { all: 0.03, normal: 0.0035 },
  skirt: { all: 0.03, normal: 0.01 },
};

const isThere = existsSync(FOLDER);
const load = (name: string): Model =>
  readModel(readFileSync(new URL(`${name}.ply`, FOLDER)), `${name}.ply`).model;

test.skipIf(!isThere)(
  'clothes fit bodies by the skins of a match, and nothing of them is inside',
  async () => {
    const { landmarks } = JSON.parse(readFileSync(new URL('body_regions.json', FOLDER), 'utf8'));
    const models = new Map<string, Model>();
    const runner = new Runner({
      kernel: await loadKernel(),
      models: {
        load: async (name) => {
          if (!models.has(name)) models.set(name, load(name));
          return models.get(name)!;
        },
      },
    });
    const match = {
      id: 'm',
      type: 'match',
      models: BODIES.map((body) => `body_${body}`),
      markers: MARKS.map((mark) => BODIES.map(() => landmarks[mark])),
    };
    const names = [
      ...BODIES.map((body) => `body_${body}`),
      ...GARMENTS.flatMap((garment) => BODIES.map((body) => `${garment}_${body}`)),
    ];
    for (const garment of GARMENTS)
      for (const from of BODIES)
        for (const to of BODIES) {
          if (from === to) continue;
          const dress = {
            id: 'd',
            type: 'dress',
            garment: `${garment}_${from}`,
            match: 'm',
            from: `body_${from}`,
            to: `body_${to}`,
          };
          const recipe = parseRecipe({
            lissom: 1,
            models: Object.fromEntries(names.map((name) => [name, { file: `${name}.ply` }])),
            steps: [match, dress],
          });
          const { model, report } = (await runner.run(recipe)).get('d') as StepResult<'dress'>;
          const error = apart(model, load(`${garment}_${to}`));
          console.log(
            `${garment}, ${from} -> ${to}: ${(100 * error.all).toFixed(2)} cm, along the normal ${(100 * error.normal).toFixed(2)} cm, ` +
              `inside before ${JSON.stringify(report.insideBefore)}`,
          );
          expect([report.inside, report.insideCentres]).toEqual([0, 0]);
          expect(error.all).toBeLessThan(MOST[garment].all);
          expect(error.normal).toBeLessThan(MOST[garment].normal);
        }
  },
  600_000,
);

/** Both of one connectivity. */
function apart(worn: Model, truth: Model): { readonly all: number; readonly normal: number } {
  const normals = vertexNormals(truth);
  let [all, normal] = [0, 0];
  for (let at = 0; at < truth.positions.length; at += 3) {
    const off = [0, 1, 2].map((axis) => worn.positions[at + axis]! - truth.positions[at + axis]!);
    all += Math.hypot(...off);
    normal += Math.abs(off.reduce((sum, value, axis) => sum + value * normals[at + axis]!, 0));
  }
  return { all: all / vertexCount(truth), normal: normal / vertexCount(truth) };
}

/** Unit, by area. */
function vertexNormals({ positions, faceOffsets, faceVertices }: Model): Float64Array {
  const normals = new Float64Array(positions.length);
  const point = (vertex: number) => positions.subarray(3 * vertex, 3 * vertex + 3);
  for (let face = 0; face + 1 < faceOffsets.length; face++) {
    const corners = faceVertices.subarray(faceOffsets[face], faceOffsets[face + 1]);
    for (let k = 1; k + 1 < corners.length; k++) {
      const [a, b, c] = [corners[0]!, corners[k]!, corners[k + 1]!].map(point);
      const u = [0, 1, 2].map((axis) => b![axis]! - a![axis]!);
      const v = [0, 1, 2].map((axis) => c![axis]! - a![axis]!);
      for (const vertex of [corners[0]!, corners[k]!, corners[k + 1]!])
        for (const axis of [0, 1, 2]) {
          const [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
          normals[3 * vertex + axis]! += u[next]! * v[last]! - u[last]! * v[next]!;
        }
    }
  }
  for (let at = 0; at < normals.length; at += 3) {
    const length = Math.hypot(normals[at]!, normals[at + 1]!, normals[at + 2]!) || 1;
    for (const axis of [0, 1, 2]) normals[at + axis]! /= length;
  }
  return normals;
}
