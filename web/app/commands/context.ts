import type { ViewportPort } from '../../view/types';
import type {
  DeformService,
  FileService,
  HairService,
  MergeService,
  SettingsService,
  WorkspaceService,
} from '../api';
import type { Document } from '../document';
import type { State } from '../state';

/** What commands act on. */
export interface CommandContext {
  readonly state: State;
  readonly document: Document;
  readonly deform: DeformService;
  readonly hair: HairService;
  readonly merge: MergeService;
  readonly workspaces: WorkspaceService;
  readonly files: FileService;
  readonly settings: SettingsService;
  readonly viewport: ViewportPort | null;
  readonly gestures: {
    /** Ends a gesture under way without a trace. @returns whether there was one */
    cancel(): boolean;
    /** Takes back the last stroke of something that is built in several. @returns whether there was one */
    back(): boolean;
  };
}
