import { bowl, dome, tube } from '../../kernel/tubes';
import { kernelGenerator } from '../kernel';
import { MERGE } from '../recipes';

export default kernelGenerator({
  kind: 'merge run',
  every: 30,
  recipe: MERGE,
  models: { s: { name: 's', ...tube(5, 12, dome) }, t: { name: 't', ...tube(5, 15, bowl, false) } },
});
