import { useApp } from '../context';
import { StepsPanel } from '../shell/steps-panel';
import { MarkersPanel } from './markers-panel';
import { ModelsPanel } from './models-panel';
import { OptionsPanel } from './options-panel';
import { QualityPanel } from './quality-panel';
import { ResultPanel } from './result-panel';

/** The side panel of the match workspace. */
export function MatchPanels() {
  const { state } = useApp();
  if (state.choosing.value) return <ModelsPanel />;
  return (
    <>
      <ModelsPanel />
      <MarkersPanel />
      <QualityPanel />
      <ResultPanel />
      <OptionsPanel />
      <StepsPanel />
    </>
  );
}
