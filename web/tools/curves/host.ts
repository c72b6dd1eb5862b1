import type { CurvesStep } from '../../recipe/steps/curves';
import type { ControlLinesPort } from '../../view/overlays/types';
import type { PointerSample, Vec3, ViewportPort } from '../../view/types';
import type { Mat4 } from '../geometry';
import type { Line } from '../stroke/polyline';
import type { Ray } from '../stroke/support';
import type { Grip } from './items';

/** The open curves step and the model that it bends, as tools read them. */
export interface CurvesScene {
  /** The committed step: what a gesture starts from. */
  readonly step: CurvesStep;
  readonly selected: Grip | null;
  /** From each curve's own space to where it is on screen: what it takes over from its parent. */
  readonly parents: readonly Mat4[];
  /** The end of each curve that stays. */
  readonly anchors: readonly ('start' | 'end')[];
  /** The model's largest extent. */
  readonly size: number;
}

/** What an edit is called in the history. */
export type CurvesLabel = 'draw' | 'move' | 'reach' | 'turn' | 'twist' | 'scale' | 'link' | 'end';

export interface CurvesEdit {
  readonly step: CurvesStep;
  readonly selected: Grip | null;
}

/** A stroke and the rays of sight through its places. */
export interface DrawnStroke {
  readonly samples: readonly Pick<PointerSample, 'x' | 'y'>[];
  readonly rays: readonly Ray[];
}

export type CurvesRemark = 'too-short' | 'ring';

export type CurvesView = Pick<ViewportPort, 'camera' | 'pointOnScreenPlane' | 'project' | 'pixelSize'>;

/** What curve tools need of the app: one scene in, edits out. Tests use doubles. */
export interface CurvesHost {
  readonly view: CurvesView;
  readonly lines: Pick<ControlLinesPort, 'pickLine'>;
  /** `null` while no model is open. */
  scene(): CurvesScene | null;
  /** Whether a drag moves the chain up to the point, and not the point alone. */
  reaches(): boolean;
  /** Whether a drag moves the ends of curves along them: trims or extends. */
  slides(): boolean;
  /** How many neighbours on either side share a twist or a width. */
  range(): number;
  /** Shows what a press would take hold of. */
  hover(grip: Grip | null): void;
  preview(edit: CurvesEdit): void;
  commit(label: CurvesLabel, edit: CurvesEdit): void;
  cancel(): void;
  select(grip: Grip | null): void;
  /** Shows a line under way that is no edit yet; `null` ends it. */
  showStroke(line: Line | null): void;
  /** Makes a curve of a finished stroke, or says why not. */
  draw(stroke: DrawnStroke): Promise<void>;
  /** A stroke under way: what it would become. */
  foresee(stroke: DrawnStroke): void;
  /** How far a drag may go before the surface folds, from 0 to 1. */
  share(from: CurvesStep, to: CurvesStep): Promise<number>;
  /** Says whether the drag under way has been stopped. */
  showStopped(stopped: boolean): void;
  /** Points of a chain whose one point reaches for a target, segments as long as before. */
  reach(
    points: readonly Vec3[],
    end: number,
    target: Vec3,
    held: readonly number[],
  ): Promise<readonly Vec3[]>;
  failed(error: unknown): void;
  say(remark: CurvesRemark): void;
}
