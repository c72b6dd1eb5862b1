import type { CameraRig } from './camera-rig';
import { pngOf } from './kept-picture';
import type { ModelView } from './model-view';
import type { CameraState, RegionPaint } from './values';

/** What is pictured. */
interface Sitter {
  readonly viewport: { camera: CameraState; setRegions(regions: readonly RegionPaint[]): void };
  readonly regions: readonly RegionPaint[];
  readonly canvas: HTMLCanvasElement;
  readonly heatShown: { value: boolean };
  readonly rig: Pick<CameraRig, 'look' | 'frame' | 'jump'>;
  /** Calls back while the canvas has the wanted size and shows no tools, and puts everything else back. */
  drawAside(draw: () => void): void;
  render(): void;
}

/** A model with its vertices at other places, from the home view: within one task, so that nobody sees the detour. */
export function thumbnail(
  view: ModelView | undefined,
  positions: Float64Array,
  { viewport, regions, canvas, heatShown, rig, drawAside, render }: Sitter,
): Promise<Blob> {
  const copy = document.createElement('canvas');
  if (!view) return pngOf(copy);
  const { posed } = view;
  const { camera } = viewport;
  const heat = heatShown.value;
  heatShown.value = false;
  viewport.setRegions([]);
  view.setPositions(positions);
  drawAside(() => {
    rig.look('home');
    rig.frame(view.places());
    rig.jump();
    render();
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    copy.getContext('2d')?.drawImage(canvas, 0, 0);
    view.setPositions(posed);
    viewport.camera = camera;
    heatShown.value = heat;
    viewport.setRegions(regions);
  });
  return pngOf(copy);
}
