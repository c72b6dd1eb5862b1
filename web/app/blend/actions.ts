// What panels, commands and tools ask of the open blend step; each edit is one step of undo, except previews.

import { diagonalOf } from '../../core/diagonal';
import { LissomError } from '../../core/errors';
import { fromIndices } from '../../core/vertex-set';
import * as edit from '../../recipe/edit';
import type { MatchStep } from '../../recipe/recipe';
import { type BlendPart, type BlendStep, newBlendStep } from '../../recipe/steps/blend';
import { addedPart, partVertices, withoutPart, withPart, withVertices } from '../../tools/blend/edits';
import { usualFeather } from '../../tools/blend/feather';
import * as weights from '../../tools/blend/weights';
import type { PaintVerb } from '../../tools/paint-tool';
import { t } from '../i18n';
import type { WingParts } from '../wing-parts';
import { BlendEdits } from './edits';
import { matchFor } from './matches';
import { Measuring } from './measuring';
import type { BlendState } from './state';

/** One model of the blend, as its row shows it. */
export interface WeightRow {
  readonly name: string;
  readonly weight: number;
  /** What the measures made of it, where that is something else. */
  readonly found: number | null;
}

export class BlendActions {
  readonly edits: BlendEdits;
  readonly measuring: Measuring;

  constructor(
    private readonly parts: Pick<WingParts, 'state' | 'document' | 'messages'>,
    private readonly own: BlendState,
  ) {
    this.edits = new BlendEdits(parts.document);
    this.measuring = new Measuring(this.edits, own, parts.messages);
  }

  /** @throws LissomError `blend-no-match` where no models are matched */
  start(): void {
    const { document, state } = this.parts;
    const match = matchFor(document.recipe, document.selection.step);
    if (!match) throw new LissomError('blend-no-match', t('error.blend-no-match'));
    const id = edit.freeId('blend', document.recipe);
    const recipe = edit.addStep(document.recipe, newBlendStep(id, match.id, match.models));
    document.commit(t('history.blend.start'), recipe, { step: id, item: null });
    state.tool.value = 'pick-part';
  }

  /** Reads signals. */
  matches(): readonly MatchStep[] {
    return edit.stepsOf(this.parts.state.recipe.value, 'match');
  }

  chooseMatch(id: string): void {
    const { step } = this.edits;
    const match = edit.stepOf(this.parts.document.recipe, id, 'match');
    if (!step || !match || step.match === id) return;
    this.own.corners.value = null;
    this.edits.commit(t('history.blend.match'), newBlendStep(step.id, id, match.models), null);
  }

  /** Names of the models, in their order. Reads signals. */
  names(): readonly string[] {
    const step = this.own.step.value;
    return (step && edit.stepOf(this.parts.state.recipe.value, step.match, 'match')?.models) ?? [];
  }

  /** Reads signals. */
  rows(): readonly WeightRow[] {
    const given = this.own.step.value?.weights ?? {};
    const found = this.measuring.isWanted() ? this.own.figures.value?.weights : undefined;
    return this.names().map((name) => ({
      name,
      weight: given[name] ?? 0,
      found: found?.[name] ?? null,
    }));
  }

  /** Reads signals. */
  sum(): number {
    return weights.rounded(weights.sumOf(this.own.step.value?.weights ?? {}));
  }

  /** The models at the corners of the triangle; `null` where there are fewer than three. Reads signals. */
  corners(): weights.Three | null {
    const names = this.names();
    const chosen = this.own.corners.value;
    if (chosen?.every((name) => names.includes(name))) return chosen;
    return names.length < 3 ? null : ([names[0]!, names[1]!, names[2]!] as const);
  }

  /** Another model at a corner; the one that was there goes where the other came from. */
  setCorner(at: number, name: string): void {
    const corners = this.corners();
    if (!corners) return;
    const from = corners.indexOf(name);
    this.own.corners.value = corners.map((each, k) =>
      k === at ? name : k === from ? corners[at]! : each,
    ) as unknown as weights.Three;
  }

  setWeight(name: string, value: number, live = false): void {
    const step = this.#now(live);
    if (!step) return;
    const next = this.own.free.peek()
      ? { ...step.weights, [name]: weights.rounded(value) }
      : weights.sharing(step.weights, this.names(), name, value);
    this.#put(step, next, live);
  }

  setShares(shares: readonly [number, number, number], live = false): void {
    const step = this.#now(live);
    const corners = this.corners();
    if (step && corners)
      this.#put(step, weights.withShares(step.weights, this.names(), corners, shares), live);
  }

  normalise(): void {
    const { step } = this.edits;
    if (step) this.#put(step, weights.normalised(step.weights, this.names()), false);
  }

  /** As much of each. */
  even(): void {
    const { step } = this.edits;
    if (step) this.#put(step, weights.normalised({}, this.names()), false);
  }

  /** All of one. */
  only(name: string): void {
    const { step } = this.edits;
    if (step)
      this.#put(step, Object.fromEntries(this.names().map((each) => [each, each === name ? 1 : 0])), false);
  }

  /** Weights that were found become those that are given; the measures are only measured from then on. */
  keepFound(): void {
    const { step } = this.edits;
    const found = this.own.figures.peek()?.weights;
    if (!step || !found) return;
    const kept = Object.fromEntries(
      Object.entries(found).map(([name, weight]) => [name, weights.rounded(weight)]),
    );
    this.edits.commit(t('history.blend.keep'), { ...this.measuring.released(step), weights: kept });
  }

  partName(
    index: number,
    part: Pick<BlendPart, 'name'> | undefined = this.own.step.value?.parts[index],
  ): string {
    return part?.name ?? t('blend.part', { number: index + 1 });
  }

  /** Whose shape the next part takes. Reads signals. */
  nextFrom(): string {
    const names = this.names();
    const chosen = this.own.nextFrom.value;
    if (chosen !== null && names.includes(chosen)) return chosen;
    const given = this.own.step.value?.weights ?? {};
    return names.reduce(
      (least, name) => ((given[name] ?? 0) < (given[least] ?? 0) ? name : least),
      names[0] ?? '',
    );
  }

  /** @param index  `null`: a new part */
  setVertices(index: number | null, vertices: Uint32Array, verb: PaintVerb): void {
    const { step } = this.edits;
    const count = this.#count;
    if (!step || count === 0) return;
    if (index === null) {
      if (vertices.length === 0) return;
      const part: BlendPart = {
        from: this.nextFrom(),
        vertices: fromIndices(vertices, count),
        how: 'paste',
      };
      this.edits.commit(t('history.blend.add-part'), addedPart(step, part), step.parts.length);
      return;
    }
    const next = withVertices(step, index, vertices, count);
    const label = t(`history.blend.${verb}`, { name: this.partName(index, step.parts[index]) });
    this.edits.commit(label, next, next.parts.length < step.parts.length ? null : index);
  }

  changePart(index: number, change: Partial<Omit<BlendPart, 'vertices'>>, live = false): void {
    const step = this.#now(live);
    if (!step?.parts[index]) return;
    const name = this.partName(index, step.parts[index]);
    this.edits.put(t('history.blend.change-part', { name }), withPart(step, index, change), live);
  }

  /** How far a part goes over, whether somebody said so or not. Reads signals. */
  featherOf({ feather, from, vertices }: BlendPart): number {
    const skins = this.own.skins.value;
    if (feather !== undefined || !skins) return feather ?? 0;
    const positions = skins.positions[skins.names.indexOf(from)];
    const { triangles } = skins.skin.opened;
    return positions
      ? usualFeather(positions, triangles, partVertices({ vertices }, positions.length / 3))
      : 0;
  }

  /** As suits the part. */
  resetFeather(index: number): void {
    const { step } = this.edits;
    const part = step?.parts[index];
    if (!step || !part) return;
    const { feather: _feather, ...rest } = part;
    const label = t('history.blend.change-part', { name: this.partName(index, part) });
    this.edits.commit(label, { ...step, parts: step.parts.map((each, i) => (i === index ? rest : each)) });
  }

  removePart(index: number): void {
    const { step } = this.edits;
    if (!step?.parts[index]) return;
    const name = this.partName(index, step.parts[index]);
    this.edits.commit(t('history.blend.remove-part', { name }), withoutPart(step, index), null);
  }

  /** Vertices of the selected part. */
  selected(): Uint32Array | undefined {
    const { item } = this.parts.document.selection;
    const part = item === null ? undefined : this.own.step.peek()?.parts[item];
    return part && partVertices(part, this.#count);
  }

  /** How far a part may go over, in units of the model. Reads signals. */
  size(): number {
    const positions = this.own.skins.value?.skin.model.positions;
    return positions?.length ? diagonalOf(positions) : 0;
  }

  #put(step: BlendStep, next: weights.Weights, live: boolean): void {
    this.edits.put(t('history.blend.weights'), { ...step, weights: { ...next } }, live);
  }

  /** What a control goes on from: while it moves, what it has shown so far. */
  #now(live: boolean): BlendStep | undefined {
    return live ? (this.own.step.peek() ?? this.edits.step) : this.edits.step;
  }

  get #count(): number {
    return (this.own.skins.peek()?.skin.model.positions.length ?? 0) / 3;
  }
}
