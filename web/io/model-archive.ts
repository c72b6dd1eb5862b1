import { zipSync } from 'fflate';
import type { Model } from '../core/model';
import { writeModel } from './formats';

/** Zip's earliest date, so that equal models are equal files. */
const DATE = new Date(1980, 0, 1);

/** Several models as one zip archive: a file for each, called after it, those of one name by number. */
export function writeModelArchive(models: readonly Model[], format: 'obj' | 'ply'): Uint8Array {
  const files: Record<string, Uint8Array> = {};
  for (const model of models) {
    const stem = model.name.replace(/\.[^.]*$/, '').replace(/[/\\]/g, ' ') || 'model';
    let name = `${stem}.${format}`;
    for (let n = 2; Object.hasOwn(files, name); n++) name = `${stem} ${n}.${format}`;
    files[name] = writeModel(model, format);
  }
  return zipSync(files, { mtime: DATE });
}
