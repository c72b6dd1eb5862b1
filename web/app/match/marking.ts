// What is marked on the models: numbered markers, lines, and what is ignored. Each edit is one step of undo.

import { diagonalOf } from '../../core/diagonal';
import { fromIndices } from '../../core/vertex-set';
import type { MatchStep } from '../../recipe/recipe';
import { isDrawn, isWhole, MAX_MARKER_CURVES, MAX_MARKERS, type MarkerPlace } from '../../recipe/steps/match';
import { gap } from '../../tools/geometry';
import {
  missing,
  withMask,
  withoutCurve,
  withoutMarker,
  withPlace,
  withRow,
  withSharp,
} from '../../tools/match/edits';
import type { MarkVerb } from '../../tools/match/host';
import { nearestSpot, pointOf, type Spot } from '../../tools/match/places';
import type { PaintVerb } from '../../tools/paint-tool';
import type { Vec3 } from '../../view/types';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import type { MatchEdits } from './edits';
import { curveItem, curveOf, type MatchState, sharpItem, sharpOf } from './state';

/** Shares of a model's size: what lies nearer to the plane of symmetry is its own mirror image; images may be so far off. */
const ON_PLANE = 0.008;
const IMAGE = 0.03;

export class Marking {
  constructor(
    private readonly edits: MatchEdits,
    private readonly own: MatchState,
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'messages'>,
  ) {}

  preview(marker: number, model: number, { place }: Spot): void {
    const { step } = this.edits;
    if (!step || marker >= MAX_MARKERS) return;
    this.edits.preview(
      t('history.match.move', { number: marker + 1 }),
      withPlace(step, marker, model, place),
      marker,
    );
  }

  /** Sets a marker on a model; with the mirror on its image too, where that has one. */
  set(verb: MarkVerb, marker: number, model: number, spot: Spot): void {
    const { step } = this.edits;
    if (!step) return;
    if (marker >= MAX_MARKERS) {
      this.edits.cancel();
      this.parts.messages.toast('warn', t('match.too-many', { count: MAX_MARKERS }));
      return;
    }
    let next = withPlace(step, marker, model, spot.place);
    const image = this.parts.state.mirror.peek() ? this.#image(model, spot.point) : null;
    const partner = image && this.#partner(step, marker);
    if (image && partner !== null && partner < MAX_MARKERS)
      next = withPlace(next, partner, model, image.place);
    this.edits.commit(t(`history.match.${verb}`, { number: marker + 1 }), next, marker);
  }

  /** Takes up the suggested place on the model that is next. */
  accept(): void {
    const ghost = this.next();
    if (ghost) this.set('place', ghost.marker, ghost.model, ghost.spot);
  }

  /** The suggestion for the model that is next. Reads signals. */
  next() {
    const at = this.nextModel();
    return this.own.ghosts.value.find(({ model }) => model === at);
  }

  /** The model on which the selected marker or curve is missing first; `null`: it is everywhere, or none is selected. */
  nextModel(): number | null {
    const step = this.own.step.value;
    const [marker, curve] = [this.own.marker.value, this.own.curve.value];
    const held = marker === null ? undefined : step?.markers[marker];
    if (held) return missing(held)[0] ?? null;
    const rows = curve === null ? undefined : step?.curves?.[curve];
    const at = rows?.findIndex(({ length }) => length < 2) ?? -1;
    return at < 0 ? null : at;
  }

  remove(item: number): void {
    const { step } = this.edits;
    if (!step) return;
    const [curve, sharp] = [curveOf(item), sharpOf(item)];
    if (sharp) this.setSharp(sharp.model, sharp.row, []);
    else if (curve !== null)
      this.edits.commit(t('history.match.remove-curve'), withoutCurve(step, curve), null);
    else this.edits.commit(t('history.match.remove', { number: item + 1 }), withoutMarker(step, item), null);
  }

  removeAll(): void {
    const { step } = this.edits;
    if (step) this.edits.commit(t('history.match.remove-all'), { ...step, markers: [] }, null);
  }

  setCurve(curve: number, model: number, row: MarkerPlace[]): void {
    const { step } = this.edits;
    if (!step || curve >= MAX_MARKER_CURVES || row.length < 2) return;
    this.edits.commit(
      t('history.match.curve', { number: curve + 1 }),
      withRow(step, curve, model, row),
      curveItem(curve),
    );
  }

  /** Keeps an edge of a model sharp; without any vertices leaves it. */
  setSharp(model: number, row: number, vertices: readonly number[]): void {
    const { step } = this.edits;
    if (!step) return;
    if (row >= MAX_MARKER_CURVES) {
      this.parts.messages.toast('warn', t('match.too-many-edges', { count: MAX_MARKER_CURVES }));
      return;
    }
    const gone = vertices.length < 2;
    this.edits.commit(
      t(gone ? 'history.match.remove-sharp' : 'history.match.sharp'),
      withSharp(step, model, row, vertices),
      gone ? null : sharpItem({ model, row }),
    );
  }

  setMask(verb: PaintVerb | 'clear', model: number, vertices: Uint32Array): void {
    const { step } = this.edits;
    const held = this.own.models.peek()[model];
    if (!step || !held) return;
    const set = fromIndices(vertices, held.model.positions.length / 3);
    this.edits.commit(t(`history.match.mask-${verb}`), withMask(step, model, set));
  }

  /** Places of markers on a model, by number. */
  points(model: number, step: MatchStep | undefined = this.own.step.value): (Vec3 | null)[] {
    const held = this.own.models.value[model];
    if (!held || !step) return [];
    return step.markers.map((marker) => {
      const place = marker[model] ?? null;
      return place === null ? null : pointOf(held, place);
    });
  }

  /** What is set on every model, and on some only. Reads signals. */
  counts() {
    const { markers = [], curves = [] } = this.own.step.value ?? {};
    const whole = markers.filter(isWhole).length;
    return {
      whole,
      open: markers.length - whole,
      curves: curves.length,
      openCurves: curves.filter((rows) => !isDrawn(rows)).length,
    };
  }

  /** Across x = 0, as all tools mirror; `null` on that plane, or where the model has nothing there. */
  #image(model: number, [x, y, z]: Vec3): Spot | null {
    const held = this.own.models.peek()[model];
    if (!held) return null;
    const size = diagonalOf(held.model.positions);
    if (Math.abs(x) < ON_PLANE * size) return null;
    const found = nearestSpot(held, [-x, y, z]);
    return found && found.distance < IMAGE * size ? found.spot : null;
  }

  /** The marker across the plane, wherever one is set; that of a new marker is the next new one. `null`: it has none. */
  #partner(step: MatchStep, marker: number): number | null {
    const held = step.markers[marker];
    if (!held) return marker + 1;
    const images = held.map((place, model): Vec3 | null => {
      const surface = this.own.models.peek()[model];
      const point = place !== null && surface ? pointOf(surface, place) : null;
      return point && [-point[0], point[1], point[2]];
    });
    const isImage = (other: MatchStep['markers'][number], at: number) =>
      at !== marker &&
      images.every((image, model) => {
        if (!image) return true;
        const surface = this.own.models.peek()[model]!;
        const place = other[model] ?? null;
        const point = place === null ? null : pointOf(surface, place);
        return point !== null && gap(point, image) < IMAGE * diagonalOf(surface.model.positions);
      });
    const found = step.markers.findIndex(isImage);
    return found < 0 ? null : found;
  }
}
