import type * as v from 'valibot';

type StepSchema = v.StrictObjectSchema<
  v.ObjectEntries & { readonly type: v.LiteralSchema<string, undefined> },
  undefined
>;

/** Fields of a step that can hold a reference, or a list of them. */
type Named<S> = { [F in keyof S]-?: S[F] extends string | readonly string[] ? F : never }[keyof S] & string;

/** One place where a step names one of several models. */
export interface Member {
  readonly path: readonly (string | number)[];
  readonly name: string;
}

/** What everyone may know of a step type without knowing the type. */
type Facts<S> = {
  /** The reference to the model that it changes: what its result takes the place of. Of several, the first. */
  readonly main: Named<S>;
  /** Where the type is edited; `null`: nowhere of its own. */
  readonly workspace: string | null;
  /** Whether what it does can be told by joints: an output may ask for a skin. */
  readonly skin?: true;
  /**
   * Where it names single ones of the models that its reference to several stands for, by their names there.
   * @param changedBy  the model that an earlier step changes
   */
  readonly members?: (step: S, changedBy: (step: string) => string | undefined) => readonly Member[];
} & (
  | { readonly writes: 'mesh' | 'strands' }
  /** `outputs` are the names of what it leaves: `<id>/<name>` wherever a step or an output names a model. */
  | { readonly writes: 'meshes'; outputs(step: S): readonly string[] }
);

/** One step type in the table. */
export const stepType = <const S extends StepSchema, const F extends Facts<v.InferOutput<S>>>(
  schema: S,
  facts: F,
): { readonly schema: S } & F => ({ schema, ...facts });

/** A row of the table, whatever its type. */
export interface StepRow<S> {
  readonly schema: StepSchema;
  readonly main: string;
  readonly workspace: string | null;
  readonly skin?: true;
  readonly writes: 'mesh' | 'strands' | 'meshes';
  members?(step: S, changedBy: (step: string) => string | undefined): readonly Member[];
  outputs?(step: S): readonly string[];
}
