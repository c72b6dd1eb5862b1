import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { LissomError } from '../../web/core/errors';
import type { Model } from '../../web/core/model';
import { readModel } from '../../web/io';
import { makeModel } from './make-model';

export { makeModel };

export const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);
export const text = (content: Uint8Array): string => new TextDecoder().decode(content);
export const read = (content: string | Uint8Array, name = 'model'): Model =>
  readModel(typeof content === 'string' ? bytes(content) : content, name).model;

/** The code a call fails with; anything but a LissomError is thrown on. */
export function codeOf(call: () => unknown): string {
  try {
    call();
  } catch (error) {
    if (error instanceof LissomError) return error.code;
    throw error;
  }
  return 'no error';
}

export const codes = (content: string | Uint8Array, name = 'model'): string[] =>
  readModel(typeof content === 'string' ? bytes(content) : content, name).notes.map((note) => note.code);

/** The faces as lists of vertex indices. */
export const facesOf = ({ faceOffsets, faceVertices }: Model): number[][] =>
  Array.from({ length: faceOffsets.length - 1 }, (_, f) => [
    ...faceVertices.subarray(faceOffsets[f]!, faceOffsets[f + 1]!),
  ]);

/** A model of the gallery as a file. */
export const galleryFile = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`../../public/gallery/${name}`, import.meta.url)));

// The same cases in every run.
fc.configureGlobal({ seed: 20 });

const finite = fc.double({ noNaN: true, noDefaultInfinity: true });

/** Models of triangles up to `corners`-gons, with or without colours, texture coordinates per vertex or corner, and sets. */
export const models = (coordinate: fc.Arbitrary<number>, corners: number): fc.Arbitrary<Model> =>
  fc
    .record({ vertices: fc.integer({ min: 3, max: 12 }), faces: fc.integer({ min: 1, max: 8 }) })
    .chain(({ vertices, faces }) => {
      const face = fc.uniqueArray(fc.nat(vertices - 1), {
        minLength: 3,
        maxLength: Math.min(corners, vertices),
      });
      const level = fc.nat(255);
      return fc
        .record({
          positions: fc.array(coordinate, { minLength: 3 * vertices, maxLength: 3 * vertices }),
          faces: fc.array(face, { minLength: faces, maxLength: faces }),
          colors: fc.option(fc.array(level, { minLength: 4 * vertices, maxLength: 4 * vertices })),
          colorAlpha: fc.boolean(),
          uvs: fc.option(fc.array(finite, { minLength: 2 * vertices, maxLength: 2 * vertices })),
          perCorner: fc.boolean(),
          scalp: fc.option(fc.uniqueArray(fc.nat(vertices - 1))),
        })
        .map((m): Model => {
          const model = makeModel(m.positions, m.faces);
          const shift = (v: number) => (v + 1) % vertices;
          return {
            ...model,
            ...(m.colors && {
              colors: Uint8Array.from(m.colors, (c, i) => (i % 4 === 3 && !m.colorAlpha ? 255 : c)),
              colorAlpha: m.colorAlpha,
            }),
            ...(m.uvs && { uvs: Float64Array.from(m.uvs) }),
            ...(m.uvs && m.perCorner && { uvIndices: model.faceVertices.map(shift) }),
            ...(m.scalp && { vertexSets: { scalp: Uint32Array.from(m.scalp).sort() } }),
          };
        });
    });

/** Any model with any finite coordinates. */
export const anyModel = models(finite, 6);

/** Texture coordinate pairs per corner, however the model stores them. */
export const uvOfCorners = ({ uvs, uvIndices, faceVertices }: Model): number[][] | undefined =>
  uvs && Array.from(uvIndices ?? faceVertices, (i) => [uvs[2 * i]!, uvs[2 * i + 1]!]);
