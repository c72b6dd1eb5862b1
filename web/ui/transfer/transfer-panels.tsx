import { useApp } from '../context';
import { StepsPanel } from '../shell/steps-panel';
import { OptionsPanel } from './options-panel';
import { PairsPanel } from './pairs-panel';
import { PosePanel } from './pose-panel';
import { ResultPanel } from './result-panel';
import { TargetPanel } from './target-panel';

/** The side panel of the transfer workspace. */
export function TransferPanels() {
  const { state } = useApp();
  if (state.choosing.value) return <PosePanel />;
  return (
    <>
      <PosePanel />
      <TargetPanel />
      <PairsPanel />
      <OptionsPanel />
      <ResultPanel />
      <StepsPanel />
    </>
  );
}
