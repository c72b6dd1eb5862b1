// The page: everything around the viewport. Components read the app's signals and call its services.

import { render } from 'preact';
import { useState } from 'preact/hooks';
import type { App } from '../app/api';
import './base.css';
import './controls/controls.css';
import { AppContext } from './context';
import { Dialogs } from './dialogs/dialogs';
import './dialogs/dialogs.css';
import './shell/shell.css';
import { SidePanel } from './shell/side-panel';
import { Stage } from './shell/stage';
import { StatusBar } from './shell/status-bar';
import { Toasts } from './shell/toasts';
import { ToolRail } from './shell/tool-rail';
import { TopBar } from './shell/top-bar';
import './tokens.css';

function Page({ app, frame }: { app: App; frame: HTMLElement }) {
  const [panelOpen, setPanelOpen] = useState(() => window.innerWidth >= 900);
  return (
    <AppContext.Provider value={app}>
      <div class={panelOpen ? 'page' : 'page panel-closed'}>
        <TopBar panelOpen={panelOpen} onTogglePanel={() => setPanelOpen(!panelOpen)} />
        <ToolRail />
        <Stage frame={frame} />
        {panelOpen && <SidePanel />}
        <StatusBar />
      </div>
      <Toasts />
      <Dialogs />
    </AppContext.Provider>
  );
}

/** Renders the page into `root`; `frame` is the viewport's own element, placed in the middle of it. */
export function renderApp(root: HTMLElement, app: App, frame: HTMLElement): void {
  render(<Page app={app} frame={frame} />, root);
}
