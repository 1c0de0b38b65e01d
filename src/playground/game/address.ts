import type { Notice } from '../panels/notice';
import type { Banner } from '../panels/banner';
import { MAX_LINK_LENGTH } from './mission/runText';

/** ms between two changes of the address: Safari throws after 100 in 30 s. */
const EVERY = 400;
/** ms before a change that the browser refused is retried. */
const AGAIN = 5000;

export interface Address {
  /** Sets the page's query; it is written with a delay. */
  readonly write: (query: string) => void;
  /** Copies a link to the clipboard, or shows it if there is none (plain http). */
  readonly copy: (query: string, done: string) => void;
}

export function createAddress(window: Window, banner: Banner, notice: Notice): Address {
  let wanted: string | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let writtenAt = -Infinity;
  const put = () => {
    timer = undefined;
    if (wanted === null) return;
    writtenAt = performance.now();
    try {
      window.history.replaceState(null, '', wanted);
    } catch {
      // The browser's limit.
      timer = setTimeout(put, AGAIN);
      return;
    }
    wanted = null;
  };
  return {
    write(query) {
      wanted = query === '' ? window.location.pathname : query;
      if (timer !== undefined) return;
      const wait = writtenAt + EVERY - performance.now();
      if (wait <= 0) put();
      else timer = setTimeout(put, wait);
    },
    copy(query, done) {
      const link = window.location.origin + window.location.pathname + query;
      const show = () => notice.showLink('Could not copy; the link is:', link);
      const { clipboard } = window.navigator as Partial<Navigator>;
      if (clipboard === undefined) show();
      else clipboard.writeText(link).then(() => banner.flash(done), show);
    },
  };
}

/** Copies a link with a flight's inputs, which replays the same flight. The message mentions a link too long for some programs. */
export function copyFlight(
  { address, notice }: { readonly address: Address; readonly notice: Notice },
  query: string,
  done: string,
): void {
  if (query.length > MAX_LINK_LENGTH)
    notice.show(`This link has ${query.length} characters; some programs cut off links that long.`);
  address.copy(query, done);
}
