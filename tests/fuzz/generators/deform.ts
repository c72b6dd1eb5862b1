import { sheet } from '../../cli/shapes';
import { kernelGenerator } from '../kernel';
import { DEFORM } from '../recipes';

export default kernelGenerator({ kind: 'deform run', every: 10, recipe: DEFORM, models: { m: sheet(8, 8) } });
