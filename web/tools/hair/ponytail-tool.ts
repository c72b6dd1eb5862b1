import type { PointerSample, Vec3 } from '../../view/types';
import { add, anyNormal, cross, dot, scaled, subtract, unit } from '../geometry';
import { type Gesture, GestureTool } from '../stroke/gesture';
import { type Line, nearestOn, quantised } from '../stroke/polyline';
import { SupportStroke, SurfaceStroke } from '../stroke/stroke';
import { rayAt } from '../stroke/support';
import { drawing } from './drawing';
import { addPrimitive, isTooShort, kept, removePrimitive, replacePart } from './edits';
import type { HairEdit, HairEditLabel, HairHost, HairRemark, HairScene } from './host';
import { places, SHORTEST, SPACING } from './measures';
import { type Point, type Primitive, primitiveAt } from './style';

/** Magnitude of the centripetal vectors a ponytail starts with (Fu 4.5). */
export const TIGHTNESS = 0.6;
/** Points that a cross-section's ring is kept as: its middle and radius are what counts. */
const RING = 8;

/** What the selected primitive still lacks; `spine` where it is no ponytail, or a finished one. */
export type PonytailStage = 'spine' | 'section' | 'profile-0' | 'profile-1';

/** The next thing to draw. It follows from the document, so undo and reopening need no more. */
export function ponytailStage({ step, selected }: Pick<HairScene, 'step' | 'selected'>): PonytailStage {
  const primitive = primitiveAt(step, selected);
  if (primitive?.kind !== 'ponytail') return 'spine';
  const { section, profiles } = primitive.item;
  if (section.length === 0) return 'section';
  if ((profiles[0]?.length ?? 0) === 0) return 'profile-0';
  return (profiles[1]?.length ?? 0) === 0 ? 'profile-1' : 'spine';
}

/** Builds a ponytail stroke by stroke: spine from the head, section across it, a profile on either side. */
export class PonytailTool extends GestureTool<HairScene, HairHost> {
  override hover(sample: PointerSample): void {
    const scene = this.host.scene();
    this.host.aim(scene !== null && (ponytailStage(scene) !== 'spine' || sample.hit !== null));
  }

  protected begin(scene: HairScene, sample: PointerSample): Gesture | null {
    const stage = ponytailStage(scene);
    const stroke = stage === 'spine' ? this.#spine(sample) : this.#beside(sample);
    if (!stroke) return null;
    const kind = stage === 'spine' || stage === 'section' ? stage : 'profile';
    const edited = () => withPart({ scene, stage, stroke }, this.#sight);
    return drawing(this.host, { stroke, kind, label: LABELS[stage], edited }, sample);
  }

  /** Takes back the last part of the ponytail being built. @returns false when none is */
  back(): boolean {
    const scene = this.host.scene();
    const stage = scene ? ponytailStage(scene) : 'spine';
    if (!scene || scene.selected === null || stage === 'spine') return false;
    const edit =
      stage === 'section'
        ? removePrimitive(scene, scene.selected)
        : replacePart(scene, scene.selected, stage === 'profile-0' ? 'section' : 'profile-0', []);
    this.host.commit('ponytail-back', edit);
    return true;
  }

  #spine(sample: PointerSample): SurfaceStroke | null {
    return sample.hit ? new SurfaceStroke(this.host.view) : null;
  }

  /** A stroke on the spine's supporting surface, begun on it. */
  #beside(sample: PointerSample): SupportStroke | null {
    const support = this.host.support();
    if (!support?.meet(rayAt(this.host.view, sample.x, sample.y))) return null;
    return new SupportStroke(this.host.view, support);
  }

  get #sight(): Vec3 {
    const { position, target } = this.host.view.camera;
    return unit(subtract(target, position), [0, 0, -1]);
  }
}

interface Begun {
  readonly scene: HairScene;
  readonly stage: PonytailStage;
  readonly stroke: SurfaceStroke | SupportStroke;
}

const LABELS: Record<PonytailStage, HairEditLabel> = {
  spine: 'add-ponytail',
  section: 'ponytail-section',
  'profile-0': 'ponytail-profile',
  'profile-1': 'ponytail-profile',
};

/** What the stroke so far makes of the step, or why it makes nothing. */
function withPart({ scene, stage, stroke }: Begun, sight: Vec3): HairEdit | HairRemark {
  const { step, selected, height } = scene;
  if (isTooShort(stroke.line, height)) return 'too-short';
  if (stage === 'spine') {
    const spine = kept(stroke.line, height, SPACING);
    if (spine.length < 2) return 'too-short';
    const item = { spine, section: [], profiles: [], tightness: TIGHTNESS };
    return addPrimitive(scene, { kind: 'ponytail', item });
  }
  const ponytail = primitiveAt(step, selected)!;
  const points =
    stage === 'section' ? ring(ponytail, stroke.line, sight, height) : kept(stroke.line, height, SPACING);
  if (points.length < 2) return 'tail-too-thin';
  return replacePart(scene, selected!, stage, points);
}

/**
 * The cross-section that a stroke across the spine, or round it, stands for: a ring about the spine where
 * the stroke passes it, across the spine's direction there, as wide as the stroke is.
 */
export function ring(ponytail: Primitive, stroke: Line, sight: Vec3, height: number): Point[] {
  if (ponytail.kind !== 'ponytail') return [];
  const { spine } = ponytail.item;
  const middle = stroke.reduce<Vec3>((sum, point) => add(sum, scaled(point, 1 / stroke.length)), [0, 0, 0]);
  const found = nearestOn(spine, middle);
  if (!found || spine.length < 2) return [];
  const axis = unit(subtract(spine[found.segment + 1]!, spine[found.segment]!));
  const side = unit(cross(axis, sight), anyNormal(axis));
  const offsets = stroke.map((point) => dot(subtract(point, found.point), side));
  const [low, high] = [Math.min(...offsets), Math.max(...offsets)];
  // Drawn from the spine to one side it shows the radius, else the width.
  const oneSided = Math.min(-low, high) < 0.15 * (high - low);
  const radius = oneSided ? Math.max(-low, high) : (high - low) / 2;
  if (!(radius > (SHORTEST * height) / 4)) return [];
  const up = cross(axis, side);
  const points = Array.from({ length: RING }, (_, i) => {
    const angle = (2 * Math.PI * i) / RING;
    return add(
      found.point,
      add(scaled(side, radius * Math.cos(angle)), scaled(up, radius * Math.sin(angle))),
    );
  });
  return quantised(points, places(height));
}
