import { type Affine, multiply } from '../core/affine';
import { LissomError } from '../core/errors';
import type { Model } from '../core/model';
import type { Rig, RigJoint } from '../core/rig';
import { invert } from './affine';
import type { Budget } from './budget';
import { readAccessor, U8, U16 } from './gltf-accessors';
import { entry, type GltfDocument, gltfDamaged } from './gltf-document';
import { type Placement, type Scene, unlessRefused } from './gltf-scene';

/** Joints of a run of vertices and their weights, as many a vertex as it has; none where all go with one joint. */
export interface Influences {
  readonly width: 0 | 4 | 8;
  readonly indices: Uint16Array;
  readonly weights: Float32Array;
  /** The joint that all go with where the width is 0. */
  readonly whole: number;
}

interface Joint {
  readonly node: number;
  readonly skin: number | undefined;
  readonly bind: Affine;
}

/** Bytes of a joint: its matrix, its place in lists. */
const JOINT = 400;
/** Bytes of an influence, as it is kept of a run and again of the model, and as it is read. */
const KEPT = 2 + 4;
const READ = 2 * 8;
/** Indices of joints are 16 bits wide. */
const MOST = 65535;
/** How far two skins may bind a joint apart, relative to the largest number of its matrix, and have it in common. */
const ALIKE = 1e-5;
const SET = 4;

/**
 * Skins (Khronos glTF 2.0 specification, 3.7.3): each joint where it is while the model is at rest. A mesh without a skin beside
 * those that have one goes with its own node, as a joint: a hat with its head.
 */
export class RigReader {
  #joints: Joint[] = [];
  /** Numbers of joints, by skin and node. */
  readonly #numbers = new Map<string, number>();
  /** By node: the first of its joints. */
  readonly #firstOf = new Map<number, number>();
  readonly #bySkin = new Map<number, readonly number[]>();
  #fault: LissomError | undefined;
  readonly #wanted: boolean;
  #weighted = false;

  constructor(
    private readonly document: GltfDocument,
    private readonly scene: Scene,
    private readonly budget: Budget,
  ) {
    this.#fault = scene.skinFault;
    this.#wanted = scene.shown.some(({ skin }) => skin !== undefined);
  }

  /** Why there are no joints though the file has some. */
  get fault(): LissomError | undefined {
    return this.#fault;
  }

  /** @returns `null` where the model has no joints */
  read(placement: Placement, attributes: Readonly<Record<string, number>>, count: number): Influences | null {
    if (!this.#wanted || this.#fault) return null;
    try {
      if (placement.skin === undefined) return withOne(this.#ownJoint(placement));
      const joints = this.#jointsOf(placement.skin, placement.matrix);
      if (attributes.JOINTS_0 === undefined || attributes.WEIGHTS_0 === undefined) return withOne(joints[0]!);
      this.#weighted = true;
      return this.#influences(attributes, count, joints);
    } catch (error) {
      this.#fault = unlessRefused(error);
      return null;
    }
  }

  rig(
    parts: readonly {
      readonly first: number;
      readonly count: number;
      readonly influences: Influences | null;
    }[],
    vertices: number,
  ): Pick<Model, 'rig'> {
    if (!this.#weighted || this.#fault) return {};
    const influences = parts.some((part) => part.influences!.width > SET) ? 8 : 4;
    const bytes = KEPT * influences * vertices;
    if (!this.budget.holds(bytes)) {
      this.#fault = this.#tooMuch();
      return {};
    }
    this.budget.take(bytes);
    const indices = new Uint16Array(influences * vertices);
    const weights = new Float32Array(influences * vertices);
    for (const { first, count, influences: of } of parts) {
      const { width, whole } = of!;
      for (let v = 0; v < count; v++) {
        const at = influences * (first + v);
        if (width === 0) {
          indices[at] = whole;
          weights[at] = 1;
        } else {
          indices.set(of!.indices.subarray(width * v, width * (v + 1)), at);
          weights.set(of!.weights.subarray(width * v, width * (v + 1)), at);
        }
      }
    }
    const rig: Rig = { joints: this.#hung(), influences, indices, weights };
    return { rig };
  }

  #jointsOf(index: number, matrix: Affine): readonly number[] {
    const known = this.#bySkin.get(index);
    if (known) return known;
    const { document, budget } = this;
    const { joints, inverseBindMatrices } = entry(document, document.json.skins, index, 'skin');
    if (joints.length === 0) throw gltfDamaged(document.file, `skin ${index} has no joint`);
    const inverses = inverseBindMatrices === undefined ? undefined : this.#inverses(inverseBindMatrices);
    if (inverses && inverses.length < 16 * joints.length)
      throw gltfDamaged(document.file, `skin ${index} has more joints than inverse bind matrices`);
    budget.take(JOINT * joints.length);
    const numbers = joints.map((node, at) => {
      entry(document, document.json.nodes, node, 'node');
      const own = inverses && invert([...inverses.subarray(16 * at, 16 * at + 16)]);
      if (inverses && !own)
        throw gltfDamaged(
          document.file,
          `joint ${at} of skin ${index} is bound by a matrix that leads nowhere`,
        );
      return this.#number({ node, skin: index, bind: own ? multiply(matrix, own) : matrix });
    });
    this.#bySkin.set(index, numbers);
    return numbers;
  }

  #inverses(index: number): Float64Array {
    const { type } = entry(this.document, this.document.json.accessors, index, 'accessor');
    if (type !== 'MAT4')
      throw gltfDamaged(this.document.file, `accessor ${index} should hold matrices, but holds ${type}`);
    return readAccessor(this.document, index, this.budget);
  }

  #ownJoint({ node, matrix }: Placement): number {
    this.budget.take(JOINT);
    const bind = invert(matrix) ? matrix : [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...matrix.slice(12)];
    return this.#firstOf.get(node) ?? this.#number({ node, skin: undefined, bind });
  }

  /** Skins share a joint where they bind it alike. */
  #number(joint: Joint): number {
    // Both ways in single precision: as it is written again.
    const back = invert(joint.bind);
    if (!back || ![...joint.bind, ...back].every((x) => Number.isFinite(Math.fround(x))))
      throw gltfDamaged(this.document.file, `node ${joint.node} is bound beyond what numbers can hold`);
    const first = this.#firstOf.get(joint.node);
    const shared = first !== undefined && alike(this.#joints[first]!.bind, joint.bind);
    const number = shared ? first : this.#joints.push(joint) - 1;
    if (number >= MOST) throw gltfDamaged(this.document.file, `it has more than ${MOST} joints`);
    if (first === undefined) this.#firstOf.set(joint.node, number);
    this.#numbers.set(`${joint.skin},${joint.node}`, number);
    return number;
  }

  #influences(
    attributes: Readonly<Record<string, number>>,
    count: number,
    joints: readonly number[],
  ): Influences {
    const width = attributes.JOINTS_1 !== undefined && attributes.WEIGHTS_1 !== undefined ? 8 : 4;
    const bytes = KEPT * width * count;
    if (!this.budget.holds(bytes + READ * width * count)) throw this.#tooMuch();
    this.budget.take(bytes);
    const indices = new Uint16Array(width * count);
    const weights = new Float32Array(width * count);
    const sums = new Float64Array(count);
    for (let set = 0; SET * set < width; set++) {
      const named = this.#set(attributes[`JOINTS_${set}`]!, count, [U8, U16]);
      const shares = this.#set(attributes[`WEIGHTS_${set}`]!, count);
      for (const [at, share] of shares.entries()) {
        const [v, k] = [Math.floor(at / SET), at % SET];
        if (!Number.isFinite(share))
          throw gltfDamaged(this.document.file, `a weight of vertex ${v} is no number`);
        // What has no share may name any joint.
        if (!(share > 0)) continue;
        const joint = joints[named[at]!];
        if (joint === undefined)
          throw gltfDamaged(
            this.document.file,
            `vertex ${v} goes with joint ${named[at]} of a skin that has ${joints.length}`,
          );
        indices[width * v + SET * set + k] = joint;
        weights[width * v + SET * set + k] = share;
        sums[v]! += share;
      }
    }
    for (let v = 0; v < count; v++) {
      if (sums[v]! > 0) for (let k = width * v; k < width * (v + 1); k++) weights[k] = weights[k]! / sums[v]!;
      else {
        indices[width * v] = joints[0]!;
        weights[width * v] = 1;
      }
    }
    return { width, indices, weights, whole: -1 };
  }

  /** Not damaged, and no reason to refuse the rest. */
  #tooMuch(): LissomError {
    const message = `The weights of ${this.document.file} unfold too far: it repeats what it holds too often.`;
    return new LissomError('count-too-large', message);
  }

  #set(index: number, count: number, types?: readonly number[]): Float64Array {
    const accessor = entry(this.document, this.document.json.accessors, index, 'accessor');
    const { type, componentType, count: found } = accessor;
    if (type !== 'VEC4' || found !== count || (types && !types.includes(componentType)))
      throw gltfDamaged(
        this.document.file,
        `accessor ${index} does not hold four joints or weights a vertex`,
      );
    return readAccessor(this.document, index, this.budget);
  }

  /** Each joint under the nearest node above its own that is one, of its own skin where that has it. */
  #hung(): readonly RigJoint[] {
    const above = new Map<number, number | undefined>();
    for (const [node, parent] of this.scene.parents) {
      const isJoint = parent !== undefined && this.#firstOf.has(parent);
      above.set(node, isJoint ? parent : parent === undefined ? undefined : above.get(parent));
    }
    return this.#joints.map(({ node, skin, bind }) => {
      const parent = above.get(node);
      const number =
        parent === undefined ? -1 : (this.#numbers.get(`${skin},${parent}`) ?? this.#firstOf.get(parent)!);
      return { name: this.document.json.nodes![node]!.name ?? `joint ${node}`, parent: number, bind };
    });
  }
}

const withOne = (whole: number): Influences => ({
  width: 0,
  indices: new Uint16Array(),
  weights: new Float32Array(),
  whole,
});

function alike(a: Affine, b: Affine): boolean {
  const size = Math.max(...a.map(Math.abs));
  return a.every((x, at) => Math.abs(x - b[at]!) <= ALIKE * size);
}
