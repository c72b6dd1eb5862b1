import { type FaceGroup, faceCount, type Model } from '../core/model';

/** The model's groups in face order with nameless runs in the gaps: every face lies in exactly one. */
export function groupRuns(model: Model): FaceGroup[] {
  const runs: FaceGroup[] = [];
  const faces = faceCount(model);
  let end = 0;
  const cover = (to: number) => {
    if (to > end) runs.push({ name: '', start: end, end: to });
  };
  for (const group of [...(model.groups ?? [])].sort((a, b) => a.start - b.start)) {
    const start = Math.max(end, group.start);
    const stop = Math.min(faces, group.end);
    if (stop <= start) continue;
    cover(start);
    runs.push({ ...group, start, end: stop });
    end = stop;
  }
  cover(faces);
  return runs;
}
