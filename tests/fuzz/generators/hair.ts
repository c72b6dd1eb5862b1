import { egg } from '../../kernel/hair-shapes';
import { kernelGenerator } from '../kernel';
import { HAIR } from '../recipes';

export default kernelGenerator({
  kind: 'hair run',
  every: 60,
  recipe: HAIR,
  models: { h: { name: 'h', ...egg() } },
});
