import { ball } from '../../kernel/balls';
import { kernelGenerator } from '../kernel';
import { MATCH } from '../recipes';

export default kernelGenerator({
  kind: 'match run',
  every: 60,
  recipe: MATCH,
  models: {
    m: { name: 'm', ...ball(8, 10, (x, y, z) => [x, 1.3 * y, z]) },
    t: { name: 't', ...ball(9, 12, (x, y, z) => [1.4 * x, y, (1 + 0.2 * y) * z]) },
  },
});
