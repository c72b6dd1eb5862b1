// Where wings live: each is loaded when it is first needed and kept; the one whose workspace is open is on screen.

import { computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import type { Finding } from '../core/errors';
import { type Recipe, type Step, type WorkspaceId, workspaceOf } from '../recipe/recipe';
import type { WingService } from './api';
import type { Evaluation, Strategy } from './evaluated';
import { addWords } from './i18n';
import type { State } from './state';
import { PLAIN } from './strategy';
import type { Mounted, Wing } from './wing';
import type { WingModule, WingParts } from './wing-parts';

export type WingLoaders = Readonly<Record<WorkspaceId, { readonly load: () => Promise<WingModule> }>>;

export class WingRoom implements WingService {
  readonly #loading = new Map<WorkspaceId, Promise<Wing>>();
  readonly #loaded = signal<ReadonlyMap<WorkspaceId, Wing>>(new Map());
  readonly open: WingService['open'];

  constructor(
    private readonly loaders: WingLoaders,
    private readonly parts: WingParts,
    private readonly failed: (error: unknown) => void,
  ) {
    this.open = computed(() => {
      const id = parts.state.workspace.value;
      const wing = this.get(id);
      return wing ? { id, wing } : null;
    });
  }

  get(id: WorkspaceId): Wing | undefined {
    return this.#loaded.value.get(id);
  }

  load(id: WorkspaceId): Promise<Wing> {
    let loading = this.#loading.get(id);
    if (!loading) {
      loading = this.#load(id);
      this.#loading.set(id, loading);
      // What could not be fetched is asked for again when it is next needed.
      loading.catch(() => this.#loading.delete(id));
    }
    return loading;
  }

  async loadAll(): Promise<void> {
    await Promise.all(this.#ids.map((id) => this.load(id)));
  }

  /** That of a step, before it is laid open: then it is on screen at once. */
  async loadFor({ steps }: Recipe, open: string): Promise<void> {
    const step = steps.find(({ id }) => id === open);
    await this.load(workspaceOf(step) ?? this.parts.state.home);
  }

  /** Reads signals. @returns `null` until the wing is loaded */
  strategyOf(step: Step): Strategy | null {
    const id = workspaceOf(step);
    if (id === null) return PLAIN;
    return this.get(id)?.strategy ?? null;
  }

  /** Lets each wing follow what is its own. @returns the findings that are news */
  publish(shown: Evaluation | null): readonly Finding[] {
    const own = shown && workspaceOf(shown.step);
    for (const [id, wing] of this.#loaded.peek()) wing.publish?.(id === own ? shown : null);
    if (!shown) return [];
    const wing = own === null ? undefined : this.#loaded.peek().get(own);
    return wing?.warnings?.(shown) ?? shown.report?.warnings ?? [];
  }

  /** Loads the wing of the open workspace, whoever opened it. @returns the function that ends it */
  follow(): () => void {
    return effect(() => {
      const id = this.parts.state.workspace.value;
      if (!this.get(id)) untracked(() => this.load(id).catch(this.failed));
    });
  }

  async #load(id: WorkspaceId): Promise<Wing> {
    const { words, create } = await this.loaders[id].load();
    addWords(words);
    const wing = create(this.parts);
    this.#loaded.value = new Map(
      this.#ids.flatMap((each) => {
        const held = each === id ? wing : this.#loaded.peek().get(each);
        return held ? [[each, held] as const] : [];
      }),
    );
    return wing;
  }

  /** In the order of the registry. */
  get loaded(): ReadonlySignal<ReadonlyMap<WorkspaceId, Wing>> {
    return this.#loaded;
  }

  get #ids(): WorkspaceId[] {
    return Object.keys(this.loaders) as WorkspaceId[];
  }
}

/** What is on screen of the open wing, or of a file that is looked at in its place. */
export type OnScreen = Pick<Mounted, 'tools' | 'cancel' | 'back'>;
export const NOTHING_MOUNTED: OnScreen = { tools: {} };

/**
 * Mounts the wing whose workspace is open, and unmounts the one before: no two are ever on screen together. Called
 * after what shows the model.
 *
 * @returns what is on screen now, and the function that ends it
 */
export function keepMounted(
  viewport: NonNullable<WingParts['viewport']>,
  { viewing }: Pick<State, 'viewing'>,
  open: WingService['open'],
): { readonly now: () => OnScreen; readonly stop: () => void } {
  let mounted: OnScreen = NOTHING_MOUNTED;
  const stop = effect(() => {
    const looked = viewing.value;
    const wing = open.value?.wing;
    let unmount = () => {};
    untracked(() => {
      if (looked) unmount = looked.mount(viewport);
      else if (wing) {
        const own = wing.mount(viewport);
        mounted = own;
        unmount = () => own.unmount();
      }
    });
    return () => {
      mounted = NOTHING_MOUNTED;
      unmount();
    };
  });
  return { now: () => mounted, stop };
}
