// Entry of the worker that makes large built-in models.

import { type MakingOrder, type MakingReply, make } from './making';

/** A worker's end of `postMessage`, which a page has with other arguments. */
const port = self as unknown as { postMessage(reply: MakingReply, moved: Transferable[]): void };

self.onmessage = ({ data }: MessageEvent<MakingOrder>) =>
  make(data, (reply, moved) => port.postMessage(reply, moved));
