// What the hair workspace draws in the main viewport beside the model.

import { HAIR } from '../../view/hair/hair-layer';
import { BOX } from '../../view/overlays/box';
import { CONTROL_LINES } from '../../view/overlays/control-lines';
import { FIELD } from '../../view/overlays/field';
import { SUPPORT } from '../../view/overlays/support';
import type { ViewportPort } from '../../view/types';

export type HairLayers = ReturnType<typeof layersIn>['ports'];

/** Puts them into the picture, until they are taken out again. */
export function layersIn(viewport: ViewportPort) {
  const mounted = {
    hair: viewport.mount(HAIR),
    curves: viewport.mount(CONTROL_LINES),
    field: viewport.mount(FIELD),
    box: viewport.mount(BOX),
    support: viewport.mount(SUPPORT),
  };
  const { hair, curves, field, box, support } = mounted;
  return {
    ports: {
      hair: hair.port,
      curves: curves.port,
      field: field.port,
      box: box.port,
      support: support.port,
    },
    unmount: () => {
      for (const layer of Object.values(mounted)) layer.unmount();
    },
  };
}
