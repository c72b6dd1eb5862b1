import { LissomError } from '../../core/errors';
import { faceCount, type Model, vertexCount } from '../../core/model';
import type { Groom } from '../../core/strands';
import { Budget } from '../budget';
import { ByteWriter } from '../byte-writer';
import { GrowingUint32 } from '../growing';
import { type ObjExtra, readObj } from '../obj-read';
import { writeObj } from '../obj-write';
import { NO_INDEX } from '../reading';
import { TextScanner } from '../text-scanner';
import { curveCount, curvesToWrite, greatest, pointCount } from './curves';
import { FixedText, placesFor } from './fixed-text';
import type { StrandWriteOptions } from './options';
import { groomOf } from './read-groom';
import { headToWrite } from './space';

/** The head's faces, then one `l` line per strand. OBJ knows neither widths nor colours of lines. */
export function writeObjLines(groom: Groom, options: StrandWriteOptions): Uint8Array {
  const curves = curvesToWrite(groom, options);
  const head = headToWrite(groom, options);
  const out = new ByteWriter(45 * pointCount(curves));
  if (head) out.raw(writeObj(head));
  else out.text('# unit: 0.01 m\n# up: y\n');
  const text = new FixedText(out);
  const places = placesFor(greatest(curves.points));
  text.text('o Strands\ng Strands\n');
  for (let i = 0; i < curves.points.length; i++) {
    text.text(i % 3 === 0 ? 'v ' : ' ');
    text.decimal(curves.points[i]!, places);
    if (i % 3 === 2) text.text('\n');
  }
  const first = (head ? vertexCount(head) : 0) + 1;
  for (let i = 0; i < curveCount(curves); i++) {
    text.text('l');
    for (let p = curves.offsets[i]!; p < curves.offsets[i + 1]!; p++) {
      text.text(' ');
      text.integer(first + p);
    }
    text.text('\n');
  }
  text.flush();
  return out.finish();
}

const LOWER_L = 108;
const LOWER_V = 118;

/** Whether an OBJ has an `l` statement at all. */
export function hasObjLines(bytes: Uint8Array): boolean {
  for (let at = bytes.indexOf(LOWER_L); at >= 0; at = bytes.indexOf(LOWER_L, at + 1)) {
    const before = at === 0 ? 10 : bytes[at - 1];
    const after = bytes[at + 1];
    if ((before === 10 || before === 13) && (after === 32 || after === 9)) return true;
  }
  return false;
}

/**
 * The lines of an OBJ as strands, its faces as the head. Lines that begin where the one before ended are one strand,
 * as programs that write each segment by itself mean it.
 *
 * @param mesh  what `readModel` made of the file, if that is known already
 * @throws LissomError `file-not-a-mesh`, `no-strands`, `file-damaged`, `file-too-large`, `file-unfolds-too-far`
 */
export function readObjLines(bytes: Uint8Array, name: string, mesh?: Model): Groom {
  const model = mesh?.origin?.format === 'obj' ? mesh : readObj(bytes, name).model;
  const budget = new Budget('strands', name, bytes.length);
  const { offsets, vertices } = readLines(bytes, name, vertexCount(model), budget);
  budget.take(24 * vertices.length);
  const points = new Float64Array(3 * vertices.length);
  vertices.forEach((v, i) => {
    for (let k = 0; k < 3; k++) points[3 * i + k] = model.positions[3 * v + k]!;
  });
  const groom = groomOf(name, { offsets, points });
  return faceCount(model) > 0 ? { ...groom, head: onlyFaces(model) } : groom;
}

function readLines(bytes: Uint8Array, name: string, total: number, budget: Budget) {
  const text = new TextScanner(bytes, 0, true);
  const offsets = new GrowingUint32(budget);
  const vertices = new GrowingUint32(budget);
  offsets.push(0);
  let seen = 0;
  let last = NO_INDEX;
  while (text.toNextWord()) {
    const c = text.bytes[text.at];
    const next = text.bytes[text.at + 1];
    const single = next === 32 || next === 9;
    if (c === LOWER_V && single) seen++;
    if (c === LOWER_L && single) {
      text.at++;
      for (let first = true; !text.atLineEnd(); first = false) {
        const written = text.integer();
        if (text.slash()) text.word();
        const v = written < 0 ? seen + written : written - 1;
        if (!(v >= 0 && v < total)) {
          const message = `${name} names vertex ${written} in line ${text.line}, but has ${total}. Export it again.`;
          throw new LissomError('file-damaged', message);
        }
        if (first && v === last) continue;
        if (first && vertices.length > 0) offsets.push(vertices.length);
        vertices.push(v);
        last = v;
      }
    }
    text.nextLine();
  }
  if (vertices.length > 0) offsets.push(vertices.length);
  return { offsets: offsets.finish(), vertices: vertices.finish() };
}

/** The model without what belongs to the strands: vertices that no face names, and lines after the last face. */
function onlyFaces(model: Model): Model {
  const { positions, colors, faceVertices } = model;
  const { comments, statements } = model.origin!.extra as ObjExtra;
  const extra: ObjExtra = { comments, statements: statements.filter(({ face }) => face < faceCount(model)) };
  const count = vertexCount(model);
  const place = new Uint32Array(count);
  for (const v of faceVertices) if (v < count) place[v] = 1;
  const kept: number[] = [];
  for (let v = 0; v < count; v++) if (place[v]) place[v] = kept.push(v) - 1;
  return {
    ...model,
    positions: Float64Array.from(
      { length: 3 * kept.length },
      (_, i) => positions[3 * kept[(i / 3) | 0]! + (i % 3)]!,
    ),
    faceVertices: faceVertices.map((v) => (v < count ? place[v]! : v)),
    origin: { format: 'obj', extra },
    ...(colors && {
      colors: Uint8Array.from({ length: 4 * kept.length }, (_, i) => colors[4 * kept[i >> 2]! + (i & 3)]!),
    }),
  };
}
