// Entry of the worker that reads links: whatever a link holds, the page goes on answering meanwhile.

import { answerLink } from './read-link';

self.onmessage = ({ data }: MessageEvent<string>) => self.postMessage(answerLink(data));
