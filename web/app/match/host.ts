// The app's side of the match tools, one for each model.

import type { MarkerPlace } from '../../recipe/steps/match';
import type { Brush, Paint } from '../../tools/brush-stroke';
import type { MarkVerb, MatchHost, MatchScene } from '../../tools/match/host';
import type { Spot } from '../../tools/match/places';
import type { PaintVerb } from '../../tools/paint-tool';
import type { Line } from '../../tools/stroke/polyline';
import type { ViewportPort } from '../../view/types';
import { t } from '../i18n';
import { listed } from '../painted-regions';
import { brushOf, SurfaceAids } from '../surface-aids';
import type { WingParts } from '../wing-parts';
import type { MatchActions } from './actions';
import type { MatchState } from './state';

interface Parts extends Pick<WingParts, 'state' | 'messages'> {
  readonly own: MatchState;
  readonly actions: MatchActions;
}

export class AppMatchHost implements MatchHost {
  readonly #aids = new SurfaceAids();

  constructor(
    /** Number of the model. */
    readonly at: number,
    readonly view: ViewportPort,
    private readonly parts: Parts,
  ) {}

  scene(): MatchScene | null {
    const { state, own, actions } = this.parts;
    const { step } = actions.edits;
    const surface = own.models.peek()[this.at];
    if (!step || !surface || state.choosing.peek()) return null;
    return {
      step,
      at: this.at,
      surface,
      marker: own.marker.peek(),
      curve: own.curve.peek(),
      ghost: own.ghosts.peek().find(({ model }) => model === this.at)?.spot ?? null,
      sharp: step.sharp?.[this.at] ?? [],
      sharpRow: own.sharp.peek()?.model === this.at ? own.sharp.peek()!.row : null,
      edges: () => this.#aids.edgesOf(surface),
      ignored: listed(step.mask?.[this.at] ?? [], surface.model.positions.length / 3),
      ...this.#aids.of(surface, state.mirror),
    };
  }

  brush(): Brush {
    return brushOf(this.parts.state);
  }

  showPaint(paint: Paint | null): void {
    this.parts.own.stroke.value = paint && { model: this.at, mask: paint.vertices };
  }

  showLine(line: Line | null): void {
    this.parts.own.stroke.value = line && { model: this.at, line: [...line] };
  }

  previewMarker(marker: number, spot: Spot): void {
    this.parts.actions.marking.preview(marker, this.at, spot);
  }

  commitMarker(verb: MarkVerb, marker: number, spot: Spot): void {
    this.parts.actions.marking.set(verb, marker, this.at, spot);
  }

  pickMarker(marker: number): void {
    this.parts.actions.pick(marker);
  }

  commitCurve(curve: number, row: MarkerPlace[]): void {
    this.parts.actions.marking.setCurve(curve, this.at, row);
  }

  commitSharp(row: number, vertices: readonly number[]): void {
    this.parts.actions.marking.setSharp(this.at, row, vertices);
  }

  commitMask(verb: PaintVerb, vertices: Uint32Array): void {
    this.parts.actions.marking.setMask(verb, this.at, vertices);
  }

  tooShort(): void {
    this.parts.messages.toast('info', t('match.curve-short'));
  }

  cancel(): void {
    this.parts.actions.edits.cancel();
  }
}
