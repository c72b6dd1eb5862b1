import type { ViewportPort } from '../view/types';
import type { MessageService, SettingsService, WorkspaceService } from './api';
import type { Desk } from './desk';
import type { Document } from './document';
import type { EvaluatorPort, RunnerPort } from './evaluated';
import type { ModelStore } from './model-store';
import type { Panes } from './panes';
import type { State } from './state';
import type { Gestures, Wing } from './wing';

/** The shared rooms that a wing is built on. */
export interface WingParts {
  readonly state: State;
  readonly document: Document;
  readonly evaluator: EvaluatorPort;
  readonly runner: RunnerPort;
  readonly models: ModelStore;
  readonly desk: Desk;
  readonly workspaces: WorkspaceService;
  readonly messages: MessageService;
  readonly settings: SettingsService;
  readonly viewport: ViewportPort | null;
  readonly panes: Panes;
  readonly gestures: Gestures;
}

/** A wing's chunk. */
export interface WingModule {
  readonly words: Readonly<Record<string, string>>;
  create(parts: WingParts): Wing;
}
