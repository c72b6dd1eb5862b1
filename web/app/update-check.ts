// Whether the server has a newer version than the page: its start page names other scripts by then.

const HOURLY = 3_600_000;

/** Calls `found` once, as soon as a newer version is seen; looks when the page comes to the front, and hourly. */
export function watchForUpdate(page: Document, found: () => void): void {
  const current = scriptOf(page.documentElement.outerHTML);
  if (!current) return;
  let done = false;
  const look = async () => {
    if (done || page.visibilityState !== 'visible') return;
    try {
      const answer = await fetch(page.baseURI.replace(/[?#].*$/s, ''), { cache: 'no-store' });
      const newest = answer.ok ? scriptOf(await answer.text()) : undefined;
      if (newest && newest !== current) {
        done = true;
        found();
      }
    } catch {
      // Offline: there is nothing newer to be had.
    }
  };
  page.addEventListener('visibilitychange', () => void look());
  setInterval(() => void look(), HOURLY);
}

/** The entry script's address in a start page, which carries a hash of its content. */
export const scriptOf = (html: string): string | undefined =>
  /<script[^>]+src="[^"]*?(assets\/[^"]+)"/.exec(html)?.[1];
