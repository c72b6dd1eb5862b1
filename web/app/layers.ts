// The layers that the workspaces draw with in the main viewport.

import { HAIR } from '../view/hair/hair-layer';
import type { HairPort } from '../view/hair/types';
import { BOX } from '../view/overlays/box';
import { CURVES } from '../view/overlays/curves';
import { FIELD } from '../view/overlays/field';
import { MARKERS } from '../view/overlays/markers';
import { SUPPORT } from '../view/overlays/support';
import type { BoxPort, CurvesPort, FieldPort, MarkersPort, SupportPort } from '../view/overlays/types';
import type { ViewportPort } from '../view/types';

export interface Layers {
  readonly markers: MarkersPort;
  readonly hair: HairPort;
  readonly curves: CurvesPort;
  readonly field: FieldPort;
  readonly box: BoxPort;
  readonly support: SupportPort;
}

export function mountLayers(viewport: ViewportPort): {
  readonly layers: Layers;
  readonly unmount: () => void;
} {
  const mounted = {
    markers: viewport.mount(MARKERS),
    hair: viewport.mount(HAIR),
    curves: viewport.mount(CURVES),
    field: viewport.mount(FIELD),
    box: viewport.mount(BOX),
    support: viewport.mount(SUPPORT),
  };
  const { markers, hair, curves, field, box, support } = mounted;
  return {
    layers: {
      markers: markers.port,
      hair: hair.port,
      curves: curves.port,
      field: field.port,
      box: box.port,
      support: support.port,
    },
    unmount: () => {
      for (const each of Object.values(mounted)) each.unmount();
    },
  };
}
