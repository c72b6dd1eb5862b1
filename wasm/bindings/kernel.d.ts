// What the compiled module exports: every .d.ts here mirrors its .cpp one for one, by hand; a test compares the
// names. Every array passed in is copied, every array handed out belongs to JS. Errors carry `code` and `fault`.

import type { ContourModule } from './contour';
import type { CurveModule } from './curve';
import type { DeformModule } from './deform';
import type { HairModule } from './hair';
import type { IsolineModule } from './isoline';
import type { MatchModule } from './match';
import type { MergeModule } from './merge';
import type { ModelModule } from './model';
import type { SketchModule } from './sketch';
import type { TransferModule } from './transfer';
import type { WearModule } from './wear';

/** One line per wing: the registry of the bindings. */
export interface KernelModule
  extends ModelModule,
    DeformModule,
    IsolineModule,
    MergeModule,
    HairModule,
    TransferModule,
    MatchModule,
    CurveModule,
    SketchModule,
    ContourModule,
    WearModule {}

/** What kernel.mjs takes: how to make an instance once the imports are known. */
export interface KernelSettings {
  instantiateWasm(
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance, compiled: WebAssembly.Module) => void,
  ): WebAssembly.Exports;
}
