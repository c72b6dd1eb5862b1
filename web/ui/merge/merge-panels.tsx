import { useApp } from '../context';
import { StepsPanel } from '../shell/steps-panel';
import { MarksPanel } from './marks-panel';
import { OptionsPanel } from './options-panel';
import { PairsPanel } from './pairs-panel';
import { PartsPanel } from './parts-panel';
import { PlacementPanel } from './placement-panel';
import { ResultPanel } from './result-panel';

/** The side panel of the merge workspace. */
export function MergePanels() {
  const { state } = useApp();
  if (state.choosing.value) return <PartsPanel />;
  return (
    <>
      <PartsPanel />
      <MarksPanel />
      <PairsPanel />
      <ResultPanel />
      <PlacementPanel />
      <OptionsPanel />
      <StepsPanel />
    </>
  );
}
