// Whatever a wing puts on screen it takes off again: effects and layers are counted.

import { beforeEach, expect, test, vi } from 'vitest';
import type { ViewportPort } from '../../web/view/types';
import { Browser, blindViewport, MemoryStorage, Tab } from './world';

const live = vi.hoisted(() => ({ effects: 0 }));
vi.mock('@preact/signals', async (original) => {
  const actual = await original<typeof import('@preact/signals')>();
  const effect: typeof actual.effect = (...args) => {
    live.effects++;
    const stop = actual.effect(...args);
    let ended = false;
    const counted = () => {
      if (!ended) live.effects--;
      ended = true;
      stop();
    };
    return Object.assign(counted, { [Symbol.dispose]: counted });
  };
  return { ...actual, effect };
});

beforeEach(() => vi.stubGlobal('fetch', async () => new Response('', { status: 404 })));

/** A viewport that counts what is mounted in it. */
function counting(): { readonly viewport: ViewportPort; readonly mounted: () => string[] } {
  const mounted: string[] = [];
  const blind = blindViewport({});
  const viewport = blindViewport({
    mount: (kind) => {
      const held = blind.mount(kind);
      mounted.push(kind.id);
      return { port: held.port, unmount: () => void mounted.splice(mounted.indexOf(kind.id), 1) };
    },
  });
  return { viewport, mounted: () => [...mounted].sort() };
}

test('a hundred changes of workspace leave no effect and no layer behind', async () => {
  const { viewport, mounted } = counting();
  const tab = new Tab(new Browser(), new MemoryStorage(), viewport);
  await tab.openCube();
  await tab.addHandle([0], 'Tip');
  const change = async () => {
    for (const id of ['merge', 'transfer', 'deform']) {
      await tab.app.commands.run(`workspace.${id}`);
      await tab.app.evaluator.settled();
    }
    tab.app.document.openStep('deform 1');
  };
  await change();
  const before = { effects: live.effects, layers: mounted() };
  for (let i = 0; i < 50; i++) await change();
  expect({ effects: live.effects, layers: mounted() }).toEqual(before);
  expect(before.layers).toEqual(['levels', 'markers', 'motion']);
  tab.app.dispose();
  expect({ effects: live.effects, layers: mounted() }).toEqual({ effects: 0, layers: [] });
});
