import type { KernelModule } from '../../../wasm/bindings/kernel';
import type { Handlers } from '../serve';
import { contourHandlers } from './contour';
import { curveHandlers } from './curve';
import { deformHandlers } from './deform';
import { hairHandlers } from './hair';
import { isolineHandlers } from './isoline';
import { matchHandlers } from './match';
import { mergeHandlers } from './merge';
import { modelHandlers } from './model';
import { Registry } from './registry';
import { sketchHandlers } from './sketch';
import { transferHandlers } from './transfer';
import { wearHandlers } from './wear';

/** One line per wing: the registry of this floor. */
export function createHandlers(wasm: KernelModule, epoch: number): Handlers {
  const registry = new Registry(epoch);
  return {
    ...modelHandlers(wasm, registry),
    ...deformHandlers(wasm, registry),
    ...isolineHandlers(wasm, registry),
    ...mergeHandlers(wasm, registry),
    ...hairHandlers(wasm, registry),
    ...transferHandlers(wasm, registry),
    ...matchHandlers(wasm, registry),
    ...wearHandlers(wasm, registry),
    ...curveHandlers(wasm, registry),
    ...sketchHandlers(wasm, registry),
    ...contourHandlers(wasm, registry),
  };
}
