import { ModelPanel } from '../shell/model-panel';
import { StepsPanel } from '../shell/steps-panel';
import { ContoursPanel } from './contours-panel';
import { CurvePanel } from './curve-panel';
import { ListPanel } from './list-panel';
import { OptionsPanel } from './options-panel';
import { PointPanel } from './point-panel';
import { PosesPanel } from './poses-panel';
import { ResultPanel } from './result-panel';

/** The side panel of the curves workspace. */
export function CurvesPanels() {
  return (
    <>
      <ModelPanel />
      <ContoursPanel />
      <ListPanel />
      <CurvePanel />
      <PointPanel />
      <PosesPanel />
      <ResultPanel />
      <OptionsPanel />
      <StepsPanel />
    </>
  );
}
