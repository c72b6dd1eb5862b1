import type { WingParts } from '../wing-parts';
import { Aids } from './aids';
import { MergeEdits } from './edits';
import { Joins } from './joins';
import { Marking } from './marking';
import { PartChoice } from './part-choice';
import { Placing } from './placing';
import { MergeShape } from './shape';
import type { MergeState } from './state';

/** What panels, commands and tools ask of the open merge step. Each edit is one step of undo, except previews. */
export class MergeActions {
  readonly aids: Aids;
  readonly edits: MergeEdits;
  readonly part: PartChoice;
  readonly marking: Marking;
  readonly joins: Joins;
  readonly shape: MergeShape;
  readonly placing: Placing;

  constructor(parts: WingParts, own: MergeState) {
    this.aids = new Aids(own.sides);
    this.edits = new MergeEdits(parts.document);
    this.part = new PartChoice(parts, own);
    this.marking = new Marking(this.edits, own, this.aids, parts);
    this.joins = new Joins(this.edits, own);
    this.shape = new MergeShape(this.edits, own);
    this.placing = new Placing(this.edits, parts);
  }
}
