import { type FaceGroup, faceCount, type Model, vertexCount } from '../core/model';
import { ByteWriter } from './byte-writer';
import type { ObjExtra } from './obj-read';
import { NO_INDEX } from './reading';
import { unitComments } from './units-comment';

/** Colours as OBJ writes them; four decimals tell 256 levels apart. */
const LEVELS = Array.from({ length: 256 }, (_, level) => String(Number((level / 255).toFixed(4))));

/** Wavefront OBJ: polygons as they are, every coordinate in as many digits as bring back the same double. */
export function writeObj(model: Model): Uint8Array {
  const out = new ByteWriter(40 * vertexCount(model) + 10 * model.faceVertices.length);
  const extra = model.origin?.format === 'obj' ? (model.origin.extra as ObjExtra) : undefined;
  const statements = extra?.statements ?? groupStatements(model.groups ?? []);
  for (const comment of [...unitComments(model), ...(extra?.comments ?? [])]) out.text(`# ${comment}\n`);
  for (const { text } of statements) if (text.startsWith('mtllib')) out.text(`${text}\n`);
  writeVertices(out, model);
  writeTextureCoordinates(out, model);
  writeFaces(
    out,
    model,
    statements.filter(({ text }) => !text.startsWith('mtllib')),
  );
  return out.finish();
}

function writeVertices(out: ByteWriter, { positions, colors, colorAlpha }: Model): void {
  for (let v = 0; v < positions.length / 3; v++) {
    out.byte(118);
    for (let k = 0; k < 3; k++) {
      out.byte(32);
      out.decimal(positions[3 * v + k]!);
    }
    if (colors)
      for (let k = 0; k < (colorAlpha ? 4 : 3); k++) {
        out.byte(32);
        out.text(LEVELS[colors[4 * v + k]!]!);
      }
    out.byte(10);
  }
}

function writeTextureCoordinates(out: ByteWriter, { uvs }: Model): void {
  if (!uvs) return;
  for (let i = 0; i < uvs.length; i += 2) {
    out.text('vt ');
    out.decimal(uvs[i]!);
    out.byte(32);
    out.decimal(uvs[i + 1]!);
    out.byte(10);
  }
}

function writeFaces(out: ByteWriter, model: Model, statements: ObjExtra['statements']): void {
  const { faceOffsets, faceVertices, uvs, uvIndices } = model;
  let next = 0;
  const faces = faceCount(model);
  for (let f = 0; f <= faces; f++) {
    for (; next < statements.length && (statements[next]!.face <= f || f === faces); next++)
      out.text(`${statements[next]!.text}\n`);
    if (f === faces) return;
    out.byte(102);
    for (let i = faceOffsets[f]!; i < faceOffsets[f + 1]!; i++) {
      const vertex = faceVertices[i]!;
      const uv = uvIndices ? uvIndices[i]! : uvs ? vertex : NO_INDEX;
      out.byte(32);
      out.text(String(vertex + 1));
      if (uv === NO_INDEX) continue;
      out.byte(47);
      out.text(String(uv + 1));
    }
    out.byte(10);
  }
}

function groupStatements(groups: readonly FaceGroup[]): ObjExtra['statements'] {
  const out: { face: number; text: string }[] = [];
  let end = 0;
  for (const group of groups) {
    const before = out.at(-1);
    if (before && group.start > end) out.push({ face: end, text: 'g' });
    out.push({ face: group.start, text: `g ${oneLine(group.name)}`.trimEnd() });
    if (group.material) out.push({ face: group.start, text: `usemtl ${oneLine(group.material)}` });
    end = group.end;
  }
  return out;
}

const oneLine = (text: string): string => text.replace(/[\r\n]+/g, ' ');
