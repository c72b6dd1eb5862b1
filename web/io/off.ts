import { LissomError } from '../core/errors';
import { Budget } from './budget';
import { GrowingUint32 } from './growing';
import { Notes } from './notes';
import { checkAnnounced, NO_INDEX, type ReadResult, truncated } from './reading';
import { TextScanner } from './text-scanner';

/**
 * OFF as text: vertices and polygons; colours, normals and texture coordinates are left out.
 *
 * @throws LissomError `file-truncated`, `count-too-large`, `file-too-large`, `format-unsupported` for the
 *                     binary kind
 */
export function readOff(bytes: Uint8Array, name: string): ReadResult {
  const budget = new Budget('mesh', name, bytes.length);
  const notes = new Notes();
  const text = new TextScanner(bytes);
  const toWord = () => {
    while (text.toNextWord()) {
      if (text.bytes[text.at] !== 35) return;
      text.nextLine();
    }
    throw truncated(name, bytes.length + 2, bytes.length);
  };
  const next = () => {
    toWord();
    return text.number();
  };
  text.word();
  if (text.word().toUpperCase() === 'BINARY') {
    const message = `${name} is a binary OFF file, which cannot be read. Export it as PLY or as OFF text.`;
    throw new LissomError('format-unsupported', message);
  }
  text.at = 0;
  text.word();
  const [vertices, faces] = [whole(next()), whole(next())];
  next();
  checkAnnounced(name, `${vertices} vertices and ${faces} faces`, 6 * vertices + 2 * faces, bytes.length);
  budget.take(24 * vertices);
  const positions = new Float64Array(3 * vertices);
  let extras = false;
  for (let v = 0; v < vertices; v++) {
    for (let k = 0; k < 3; k++) positions[3 * v + k] = next();
    if (!text.atLineEnd() && text.bytes[text.at] !== 35) extras = true;
    text.nextLine();
  }
  const offsets = new GrowingUint32(budget);
  const corners = new GrowingUint32(budget);
  offsets.push(0);
  for (let f = 0; f < faces; f++) {
    const size = whole(next());
    const first = corners.length;
    for (let i = 0; i < size; i++) corners.push(toIndex(next()));
    if (size >= 3) offsets.push(corners.length);
    else {
      corners.length = first;
      notes.add('face-too-short', 'A face with fewer than three corners was left out.', `line ${text.line}`);
    }
    if (!text.atLineEnd() && text.bytes[text.at] !== 35) extras = true;
    text.nextLine();
  }
  if (extras) notes.add('attributes-ignored', `Colours or normals of ${name} were left out.`);
  const model = {
    name,
    positions,
    faceOffsets: offsets.finish(),
    faceVertices: corners.finish(),
  };
  return { model, notes: notes.list() };
}

/** A count; anything else counts as too many to be true. */
const whole = (value: number): number => (Number.isInteger(value) && value >= 0 ? value : 2 ** 53);

const toIndex = (value: number): number => (value >= 0 && value < NO_INDEX ? value : NO_INDEX);
