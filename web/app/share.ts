// Links that carry a recipe in their fragment. Nothing is sent to any server.

import { isCancelled, LissomError } from '../core/errors';
import { LINK_PLACES } from '../recipe/link/fits';
import { encodeLink } from '../recipe/link/link';
import type { MessageService, ShareResult, ShareService } from './api';
import type { Document } from './document';
import { t } from './i18n';

export class Share implements ShareService {
  constructor(
    private readonly document: Pick<Document, 'recipe'>,
    private readonly messages: MessageService,
    private readonly page: { readonly address: () => string; readonly copy: (text: string) => Promise<void> },
  ) {}

  async link(): Promise<ShareResult> {
    const { recipe } = this.document;
    const own = Object.values(recipe.models).find((ref) => 'file' in ref);
    if (own && 'file' in own)
      return { kind: 'needs-file', reason: t('share.needs-file', { name: own.file }) };
    try {
      const url = encodeLink(recipe, this.page.address());
      const fits = LINK_PLACES.map(({ place, limit }) => ({
        where: t(`share.where.${place}`),
        limit,
        fits: url.length <= limit,
      }));
      return { kind: 'link', url, fits };
    } catch (error) {
      if (!(error instanceof LissomError) || isCancelled(error)) throw error;
      return { kind: 'needs-file', reason: error.message };
    }
  }

  async copy(): Promise<void> {
    const result = await this.link();
    if (result.kind === 'needs-file') {
      this.messages.toast('warn', result.reason);
      return;
    }
    try {
      await this.page.copy(result.url);
      this.messages.toast('good', t('toast.link-copied', { length: result.url.length }));
    } catch {
      this.messages.toast('warn', t('toast.link-not-copied'));
    }
  }
}
