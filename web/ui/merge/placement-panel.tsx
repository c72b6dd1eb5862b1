import { useEffect, useRef, useState } from 'preact/hooks';
import { t } from '../../app/i18n';
import type { MapPlacement, RegionMaps } from '../../kernel/contract/merge';
import { dragged, type PlacementHandle, type PlanePoint } from '../../tools/merge/placement';
import { useApp } from '../context';

import { Button } from '../controls/button';
import { SliderField } from '../controls/fields';
import { Section } from '../controls/section';
import { drawMaps, frameOf, handleAt, toPlane } from './map-drawing';
import { useMerge } from './use-merge';

const SIZE = 268;

/** Both regions laid flat: how the part lies on the target is dragged, turned and scaled here. */
export function PlacementPanel() {
  const { messages } = useApp();
  const { state: own, actions: merge } = useMerge();
  const step = own.step.value;
  const marks = step?.optimalBoundary;
  const [maps, setMaps] = useState<RegionMaps | null>(null);
  const [live, setLive] = useState<MapPlacement | null>(null);
  const isMerged = own.figures.value !== null;
  useEffect(() => {
    let wanted = isMerged && marks !== undefined;
    if (!wanted) setMaps(null);
    else
      merge.placing
        .maps()
        .then((found) => wanted && setMaps(found))
        .catch((error: unknown) => messages.failed(error));
    return () => {
      wanted = false;
    };
  }, [isMerged, marks?.sourceRegion, marks?.feature, marks?.targetRegion]);
  if (!marks || !maps) return null;
  const placement = live ?? marks.placement ?? maps.placement;
  const commit = (next: MapPlacement | undefined) => {
    setLive(null);
    merge.placing.setPlacement(
      next && {
        shift: [rounded(next.shift[0]), rounded(next.shift[1])],
        turn: rounded(next.turn),
        scale: rounded(next.scale),
      },
    );
  };
  const finish = () => live && commit(live);
  return (
    <Section
      title={t('ui.merge.placement')}
      aside={
        marks.placement && (
          <Button
            icon="rotate-ccw"
            iconOnly
            label={t('ui.merge.placement.reset')}
            onClick={() => commit(undefined)}
          />
        )
      }
    >
      <MapPicture maps={maps} placement={placement} onDrag={setLive} onDrop={commit} />
      <SliderField
        label={t('ui.merge.placement.turn')}
        value={placement.turn}
        min={-180}
        max={180}
        step={1}
        digits={1}
        onChange={(turn) => setLive({ ...placement, turn })}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.merge.placement.scale')}
        value={placement.scale}
        min={0.1}
        max={3}
        step={0.01}
        digits={2}
        onChange={(scale) => setLive({ ...placement, scale })}
        onCommit={finish}
      />
    </Section>
  );
}

const rounded = (value: number): number => Number(value.toFixed(4));

interface PictureProps {
  maps: RegionMaps;
  placement: MapPlacement;
  onDrag: (placement: MapPlacement) => void;
  onDrop: (placement: MapPlacement) => void;
}

function MapPicture({ maps, placement, onDrag, onDrop }: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const drag = useRef<{ handle: PlacementHandle; start: PlanePoint; from: MapPlacement } | null>(null);
  const theme = useApp().state.display.value.theme;
  const frame = frameOf(maps, SIZE);
  useEffect(() => {
    if (canvas.current) drawMaps(canvas.current, SIZE, maps, placement);
  }, [maps, placement, theme]);
  const at = (event: PointerEvent): PlanePoint => {
    const box = canvas.current!.getBoundingClientRect();
    return toPlane(frame, event.clientX - box.left, event.clientY - box.top);
  };
  const moved = (event: PointerEvent) =>
    drag.current && dragged(drag.current.from, drag.current.handle, drag.current.start, at(event));
  return (
    <canvas
      ref={canvas}
      class="maps"
      style={{ width: `${SIZE}px`, height: `${SIZE}px` }}
      role="img"
      aria-label={t('ui.merge.placement.help')}
      title={t('ui.merge.placement.help')}
      onPointerDown={(event) => {
        const start = at(event);
        const handle = handleAt(frame, placement, start);
        if (!handle || event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { handle, start, from: placement };
      }}
      onPointerMove={(event) => {
        const next = moved(event);
        if (next) onDrag(next);
      }}
      onPointerUp={(event) => {
        const next = moved(event);
        drag.current = null;
        if (next) onDrop(next);
      }}
      onPointerCancel={() => {
        if (drag.current) onDrag(drag.current.from);
        drag.current = null;
      }}
    />
  );
}
