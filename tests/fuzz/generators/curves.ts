import { bar } from '../../kernel/shapes';
import { kernelGenerator } from '../kernel';
import { CURVES } from '../recipes';

export default kernelGenerator({
  kind: 'curves run',
  every: 20,
  recipe: CURVES,
  models: { m: { name: 'm', ...bar(12, 3) } },
});
