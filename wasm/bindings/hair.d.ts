import type {
  FieldVectors,
  GrownHair,
  HairOptions,
  HairStyle,
  OpenedHair,
  StyledHair,
} from '../../web/kernel/contract/hair';
import type { WasmObject, WasmWorkingMesh } from './model';

export interface HairModule {
  readonly HairSession: new (
    model: WasmWorkingMesh,
    scalp: Uint32Array,
    resolution: number,
    up: 'y' | 'z',
  ) => WasmHairSession;
  readonly HairGrowth: new (
    hair: WasmHairSession,
    from: number,
    count: number,
    options: HairOptions,
  ) => WasmHairGrowth;
}

export interface WasmHairSession extends WasmObject {
  /** One slice of the preparation; true while there is more. */
  step(): boolean;
  fraction(): number;
  describe(): Omit<OpenedHair, 'id' | 'peakBytes'>;
  style(style: HairStyle): StyledHair;
  field(stride: number): FieldVectors;
  constraints(): FieldVectors;
}

export interface WasmHairGrowth extends WasmObject {
  /** Some strands more; true while there are more to grow. */
  step(): boolean;
  fraction(): number;
  /** The strands, once. */
  take(): Omit<GrownHair, 'peakBytes'>;
}
