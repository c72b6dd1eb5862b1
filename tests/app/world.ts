// The app without a browser: a kernel that moves every free vertex with the first handle, memory for storage.

import { type BuiltApp, buildApp, type World } from '../../web/app/app';
import type { BlendActions } from '../../web/app/blend/actions';
import type { BlendWing } from '../../web/app/blend/wing';
import type { CurvesActions } from '../../web/app/curves/actions';
import type { CurvesWing } from '../../web/app/curves/wing';
import type { DeformActions } from '../../web/app/deform/actions';
import type { DeformWing } from '../../web/app/deform/wing';
import type { DressActions } from '../../web/app/dress/actions';
import type { DressWing } from '../../web/app/dress/wing';
import type { SaveOptions } from '../../web/app/file-dialogs';
import type { HairActions } from '../../web/app/hair/actions';
import type { HairWing } from '../../web/app/hair/wing';
import type { MatchActions } from '../../web/app/match/actions';
import type { MatchWing } from '../../web/app/match/wing';
import type { MergeActions } from '../../web/app/merge/actions';
import type { MergeWing } from '../../web/app/merge/wing';
import { type DocumentStore, hashesOf, type StoredDocument } from '../../web/app/store';
import type { TransferActions } from '../../web/app/transfer/actions';
import type { TransferWing } from '../../web/app/transfer/wing';
import type { Args, KernelId, KernelPort, Method, Result } from '../../web/kernel/contract';
import type { WorkspaceId } from '../../web/recipe/recipe';
import type { LayerKind } from '../../web/view/layer';
import type { ControlLinesPort } from '../../web/view/overlays/types';
import type { ViewportPort } from '../../web/view/types';

/** A cube of eight vertices and twelve triangles. */
export const CUBE_OBJ = [
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1} ${(i >> 1) & 1} ${i >> 2}`),
  ...[
    '1 3 4',
    '1 4 2',
    '5 6 8',
    '5 8 7',
    '1 2 6',
    '1 6 5',
    '3 7 8',
    '3 8 4',
    '1 5 7',
    '1 7 3',
    '2 4 8',
    '2 8 6',
  ].map((face) => `f ${face}`),
].join('\n');

export class FakeKernel implements KernelPort {
  readonly epoch = 0;
  readonly calls: Method[] = [];
  /** Settle arguments of the deform calls, in order. */
  readonly settles: (boolean | undefined)[] = [];
  /** Strands asked for, call by call. */
  readonly grown: number[] = [];
  /** Awaited before a call is answered. */
  before: (method: Method) => Promise<void> = async () => {};
  /** Seconds a solve claims to take. */
  solveSeconds = 0.001;
  #models: Float64Array[] = [];
  /** Markers of each match, model by model. */
  readonly matched: (readonly Float64Array[])[] = [];
  #sessions: { rest: Float64Array; moved: Set<number> }[] = [];
  #paired: Args<'prepareTransfer'>[] = [];
  #blends: Args<'prepareBlend'>[] = [];
  #fittings: Args<'prepareDress'>[] = [];
  #throughs: Args<'prepareTransferThrough'>[] = [];

  async call<M extends Method>(
    method: M,
    args: Args<M>,
    { signal }: { signal?: AbortSignal } = {},
  ): Promise<Result<M>> {
    this.calls.push(method);
    await this.before(method);
    signal?.throwIfAborted();
    return this.#answers[method]?.(args as never) as Result<M>;
  }

  #triangles: Uint32Array = new Uint32Array();

  /** The connectivity of what was opened last: that of all models here. */
  #seen(triangles: Uint32Array): Uint32Array {
    this.#triangles = triangles;
    return triangles;
  }

  readonly #answers: { readonly [M in Method]?: (args: Args<M>) => Result<M> } = {
    openModel: ({ positions, faceVertices }) => ({
      id: this.#models.push(positions) as KernelId,
      triangles: this.#seen(faceVertices),
      faceOfTriangle: Uint32Array.from({ length: faceVertices.length / 3 }, (_, i) => i),
      welded: Int32Array.from({ length: positions.length / 3 }, (_, i) => i),
      findings: [],
      components: 1,
      boundaryLoops: 0,
      eulerCharacteristic: 2,
      oriented: true,
      closed: true,
    }),
    prepareDeform: ({ model, roi, handles }) => {
      const held = new Set(handles.slice(1).flatMap(({ vertices }) => [...vertices]));
      const moved = new Set([...roi, ...handles[0]!.vertices].filter((v) => !held.has(v)));
      const id = this.#sessions.push({ rest: this.#models[model - 1]!, moved }) as KernelId;
      return {
        id,
        free: roi.length,
        degenerate: 0,
        warnings: [],
        seconds: { assemble: 0.001, factor: 0.002 },
        peakBytes: 1,
      };
    },
    deform: ({ deform, targets, settle }) => {
      this.settles.push(settle);
      const { rest, moved } = this.#sessions[deform - 1]!;
      const positions = rest.map((x, i) => (moved.has(Math.floor(i / 3)) ? x + targets[12 + (i % 3)]! : x));
      return {
        positions,
        iterations: 1,
        warnings: [],
        seconds: { solve: this.solveSeconds, rotate: 0, reconstruct: 0 },
      };
    },
    prepareTransfer: (args) => ({
      id: this.#paired.push(args) as KernelId,
      unknowns: 40,
      warnings: [],
      seconds: { fields: 0.001, reduce: 0.002 },
      peakBytes: 1,
    }),
    // A counterpart moves as the first vertex of its handle did.
    transfer: ({ transfer, pose, strength }) => {
      const { source, target, sourceHandles, targetHandles } = this.#paired[transfer - 1]!;
      const rest = this.#models[source - 1]!;
      const positions = this.#models[target - 1]!.slice();
      for (const [i, vertices] of targetHandles.entries())
        for (const v of vertices)
          for (let axis = 0; axis < 3; axis++) {
            const k = 3 * sourceHandles[i]![0]! + axis;
            positions[3 * v + axis]! += strength * (pose[k]! - rest[k]!);
          }
      return { positions, iterations: 1, warnings: [], seconds: { perIteration: 0.001, solve: 0.001 } };
    },
    // Models of one connectivity are their own skins.
    match: ({ models }) => {
      this.matched.push(models.map(({ markers }) => markers));
      const skins = models.map(({ model }) => this.#models[model - 1]!);
      return {
        triangles: this.#triangles,
        positions: skins,
        figures: skins.map(() => ({
          distance: { mean: 0.001, back: 0.002, p99: 0.01 },
          flipped: 0,
          folds: 0,
          selfIntersections: 0,
        })),
        residuals: skins.map(({ length }) => new Float32Array(length / 3)),
        poorest: skins.map(() => new Uint32Array()),
        markerVertices: new Uint32Array(),
        markerError: 0,
        iterations: 1,
        warnings: [],
        seconds: { start: 0, carry: 0, fine: 0, connectivity: 0, sharp: 0, report: 0 },
        peakBytes: 1,
      };
    },
    prepareBlend: (args) => ({
      id: this.#blends.push(args) as KernelId,
      warnings: [],
      seconds: { factor: 0.002 },
      peakBytes: 1,
    }),
    // Parts are set in as they are; every measure is the first weight, and what is wanted of one becomes it.
    blend: ({ blend, weights: given, measures }) => {
      const { positions: skins, parts } = this.#blends[blend - 1]!;
      const wanted = measures.find(({ value }) => value !== undefined)?.value;
      const weights = given.map((weight, i) => (i === 0 ? (wanted ?? weight) : weight));
      const positions = new Float64Array(skins[0]!.length);
      for (const [k, skin] of skins.entries())
        for (let i = 0; i < positions.length; i++) positions[i]! += weights[k]! * skin[i]!;
      for (const { from, vertices } of parts)
        for (const v of vertices) for (let k = 0; k < 3; k++) positions[3 * v + k] = skins[from]![3 * v + k]!;
      return {
        positions,
        weights,
        reached: Float64Array.from(measures, () => weights[0]!),
        iterations: 1,
        warnings: [],
        seconds: { measure: 0, blend: 0.001 },
      };
    },
    prepareDress: (args) => ({
      id: this.#fittings.push(args) as KernelId,
      seconds: { prepare: 0.002 },
      peakBytes: 1,
    }),
    // Cloth goes along with the first vertex of the body, and up by the ease.
    dress: ({ dress, offset }) => {
      const { garment, from, to } = this.#fittings[dress - 1]!;
      const positions = this.#models[garment - 1]!.map(
        (x, i) => x + to[i % 3]! - from[i % 3]! + (i % 3 === 1 ? offset : 0),
      );
      return {
        positions,
        before: { vertices: 3, faceCentres: 4 },
        after: { vertices: offset < 0 ? 2 : 0, faceCentres: 0 },
        rounds: 1,
        warnings: [],
        seconds: { dress: 0.001 },
      };
    },
    prepareTransferThrough: (args) => ({
      id: this.#throughs.push(args) as KernelId,
      unknowns: args.from.length / 3,
      seconds: { prepare: 0.002 },
      peakBytes: 1,
    }),
    // Vertex by vertex.
    transferThrough: ({ transfer, pose, strength }) => {
      const { source, target } = this.#throughs[transfer - 1]!;
      const rest = this.#models[source - 1]!;
      const positions = this.#models[target - 1]!.map((x, i) => x + strength * (pose[i]! - rest[i]!));
      return { positions, iterations: 1, seconds: { solve: 0.001 } };
    },
    carryPlaces: ({ places }) => places,
    guessPlace: ({ place }) => place,
    // By any angle the same edge.
    sharpEdges: () => [Uint32Array.of(0, 1, 3)],
    measure: ({ positions }) => ({
      volumeRatio: 1,
      edgeRms: 0,
      worstStretch: 1.25,
      flippedTriangles: 0,
      stretch: new Float32Array(positions.length / 3),
    }),
    openHair: () => ({
      id: 1 as KernelId,
      grid: [4, 4, 4],
      low: [-1, -1, -1],
      high: [2, 2, 2],
      headHeight: 1,
      seconds: { prepare: 0.1 },
      peakBytes: 1,
    }),
    styleHair: ({ style }) => ({
      constraints: 10 * (style.streams.length + style.partings.length + style.ponytails.length),
      warnings: [],
      seconds: { update: 0.01, field: 0.02 },
    }),
    growHair: ({ count }) => {
      this.grown.push(count);
      return {
        offsets: Uint32Array.from({ length: count + 1 }, (_, i) => 2 * i),
        points: new Float32Array(6 * count),
        origin: new Float64Array(3),
        rootUvs: new Float32Array(2 * count),
        groups: new Uint32Array(count),
        insideHead: 0,
        shortStrands: 0,
        reached: [],
        gathered: [],
        seconds: { grow: 0.3 },
        peakBytes: 1,
      };
    },
    hairField: () => ({ places: new Float32Array(3), vectors: new Float32Array(3) }),
    hairConstraints: () => ({ places: new Float32Array(6), vectors: new Float32Array(6) }),
    release: () => {},
  };
}

export class MemoryStore implements DocumentStore {
  readonly kept = new Map<string, StoredDocument>();
  readonly blobs = new Map<string, Uint8Array>();
  /** Blobs written so far, to see that unchanged ones are not written again. */
  written = 0;
  /** Refuses to write. */
  broken = false;
  /** Refuses everything. */
  silent = false;

  documents = async () => {
    if (this.silent) throw new Error('no answer');
    return [...this.kept.values()];
  };
  document = async (id: string) => this.kept.get(id);
  blob = async (hash: string) => {
    if (this.silent) throw new Error('no answer');
    return this.blobs.get(hash);
  };
  async write(
    document: StoredDocument,
    blobs: ReadonlyMap<string, Uint8Array>,
    onlyNewer = false,
  ): Promise<void> {
    if (onlyNewer && (this.kept.get(document.id)?.revision ?? -1) >= (document.revision ?? 0)) return;
    if (this.broken || this.silent) throw new Error('the disk is full');
    const missing = [...blobs].filter(([hash]) => !this.blobs.has(hash));
    for (const [hash, bytes] of missing) this.blobs.set(hash, bytes);
    this.written += missing.length;
    this.kept.set(document.id, structuredClone(document));
  }
  async remove(ids: readonly string[]): Promise<void> {
    for (const id of ids) this.kept.delete(id);
    const named = new Set([...this.kept.values()].flatMap(hashesOf));
    for (const hash of [...this.blobs.keys()]) if (!named.has(hash)) this.blobs.delete(hash);
  }
}

export class MemoryStorage {
  readonly #items = new Map<string, string>();
  full = false;
  getItem = (key: string) => this.#items.get(key) ?? null;
  setItem = (key: string, value: string) => {
    if (this.full) throw new DOMException('full', 'QuotaExceededError');
    this.#items.set(key, value);
  };
  removeItem = (key: string) => void this.#items.delete(key);
  key = (index: number) => [...this.#items.keys()][index] ?? null;
  get length(): number {
    return this.#items.size;
  }
}

/** One browser: what several tabs share. */
export class Browser {
  readonly store = new MemoryStore();
  readonly storage = new MemoryStorage();
  readonly claimed = new Map<string, Tab>();
  /** What happens while a tab waits for a document. */
  afterPatience: () => void = () => {};
  time = 1_000_000;
  ids = 0;
}

/** One tab with the app in it. */
export class Tab {
  readonly kernel = new FakeKernel();
  readonly saved: { name: string; bytes: Uint8Array }[] = [];
  readonly copied: string[] = [];
  readonly app: BuiltApp;
  reloads = 0;
  /** The link that the address shows. */
  link: string | undefined;
  /** Tells the app that another tab has a document, too. */
  lose: (id: string) => void = () => {};

  constructor(
    readonly browser = new Browser(),
    readonly session = new MemoryStorage(),
    viewport: ViewportPort | null = null,
    private readonly isReload = false,
    kernel?: KernelPort,
  ) {
    const world: World = {
      kernel: kernel ?? this.kernel,
      viewport,
      pane: () => null,
      store: browser.store,
      claims: {
        claim: async (id, patience = 0) => {
          if (patience > 0) browser.afterPatience();
          const owner = browser.claimed.get(id) ?? this;
          if (owner === this) browser.claimed.set(id, this);
          return owner === this;
        },
        isFree: async (id) => (browser.claimed.get(id) ?? this) === this,
        release: (id) => void browser.claimed.delete(id),
        onLost: (listener) => {
          this.lose = listener;
        },
      },
      dialogs: {
        open: async () => [file('cube.obj', CUBE_OBJ)],
        save: async (blob: Blob, { fileName }: SaveOptions) => {
          this.saved.push({ name: fileName, bytes: new Uint8Array(await blob.arrayBuffer()) });
          return undefined;
        },
      },
      storage: browser.storage,
      tab: session,
      galleryBase: 'https://lissom.test/gallery/',
      address: () => 'https://lissom.test/',
      settleAddress: (link) => {
        this.link = link;
      },
      copy: async (text) => void this.copied.push(text),
      isReload: this.isReload,
      persist: () => {},
      newId: () => `document-${++browser.ids}`,
      now: () => ++browser.time,
      mac: false,
      reload: () => void this.reloads++,
    };
    this.app = buildApp(world);
  }

  get blend(): BlendActions {
    return this.#wing<BlendWing>('blend').actions;
  }

  get blendState(): BlendWing['state'] {
    return this.#wing<BlendWing>('blend').state;
  }

  get dress(): DressActions {
    return this.#wing<DressWing>('dress').actions;
  }

  get dressState(): DressWing['state'] {
    return this.#wing<DressWing>('dress').state;
  }

  get curves(): CurvesActions {
    return this.#wing<CurvesWing>('curves').actions;
  }

  get curvesState(): CurvesWing['state'] {
    return this.#wing<CurvesWing>('curves').state;
  }

  get deform(): DeformActions {
    return this.#wing<DeformWing>('deform').actions;
  }

  get deformState(): DeformWing['state'] {
    return this.#wing<DeformWing>('deform').state;
  }

  get hair(): HairActions {
    return this.#wing<HairWing>('hair').actions;
  }

  get hairState(): HairWing['state'] {
    return this.#wing<HairWing>('hair').state;
  }

  get merge(): MergeActions {
    return this.#wing<MergeWing>('merge').actions;
  }

  get mergeState(): MergeWing['state'] {
    return this.#wing<MergeWing>('merge').state;
  }

  get match(): MatchActions {
    return this.#wing<MatchWing>('match').actions;
  }

  get matchState(): MatchWing['state'] {
    return this.#wing<MatchWing>('match').state;
  }

  get transfer(): TransferActions {
    return this.#wing<TransferWing>('transfer').actions;
  }

  get transferState(): TransferWing['state'] {
    return this.#wing<TransferWing>('transfer').state;
  }

  #wing<W>(id: WorkspaceId): W {
    return this.app.wings.get(id) as W;
  }

  get toasts(): string[] {
    return this.app.state.toasts.value.map(({ text }) => text);
  }

  async openCube(): Promise<void> {
    await this.app.files.openFiles([file('cube.obj', CUBE_OBJ)]);
    await this.app.evaluator.settled();
  }

  /** Adds a region handle on the given vertices. */
  async addHandle(vertices: number[], name: string): Promise<void> {
    const { document, evaluator } = this.app;
    const step = this.deform.step!;
    const handle = {
      kind: 'region' as const,
      vertices,
      matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
      name,
    };
    const steps = document.recipe.steps.map((each) =>
      each === step ? { ...step, handles: [...step.handles, handle] } : each,
    );
    const selection = { step: step.id, item: step.handles.length };
    document.commit(`Add ${name}`, { ...document.recipe, steps }, selection);
    await evaluator.settled();
  }

  /** The tab is closed, or crashes: nothing more is written, and what it claimed is free. */
  close(): void {
    this.app.dispose();
    for (const [id, owner] of this.browser.claimed) if (owner === this) this.browser.claimed.delete(id);
  }

  /** The same tab after a reload. */
  reloaded(): Tab {
    this.close();
    return this.comingBack();
  }

  /** The next page of the same tab, whether this one is quite gone or not. */
  comingBack(): Tab {
    return new Tab(this.browser, this.session, null, true);
  }
}

const STANDING: ViewportPort['camera'] = { position: [0, 0, 5], target: [0, 0, 0], orthographic: false };

/** What answers in the place of layers, by the id of their kind. */
export type LayerDoubles = Readonly<
  Record<string, Partial<ControlLinesPort> & { readonly unmounted?: () => void }>
>;

/** A viewport that shows nothing, finds nothing and takes every call; its layers likewise. */
export const blindViewport = (parts: Partial<ViewportPort>, layers: LayerDoubles = {}): ViewportPort => {
  const mount: ViewportPort['mount'] = <P>({ id }: LayerKind<P>) => ({
    port: blind(layers[id] ?? {}) as P,
    unmount: () => layers[id]?.unmounted?.(),
  });
  return blind({ camera: STANDING, mount, onDraw: () => () => {}, ...parts }) as ViewportPort;
};

/** Has what it is given; for the rest it takes every call and answers nothing. */
const blind = <T extends object>(parts: T): T =>
  new Proxy(parts, {
    get: (held, name) => Reflect.get(held, name) ?? (() => null),
    set: () => true,
  });

export const file = (name: string, content: string | Uint8Array): File =>
  new File([content as BlobPart], name);
