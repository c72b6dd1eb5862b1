import type { ViewportPort } from '../../view/types';
import type { FileService, SettingsService, WingService, WorkspaceService } from '../api';
import type { Document } from '../document';
import type { State } from '../state';
import type { Gestures } from '../wing';

/** What commands that belong to no wing act on. */
export interface CommandContext {
  readonly state: State;
  readonly document: Document;
  readonly wings: WingService;
  readonly workspaces: WorkspaceService;
  readonly files: FileService;
  readonly settings: SettingsService;
  readonly viewport: ViewportPort | null;
  readonly gestures: Gestures;
}
