import { EffectPanel } from './effect-panel';
import { HandlesPanel } from './handles-panel';
import { MethodPanel } from './method-panel';
import { ModelPanel } from './model-panel';
import { PosePanel } from './pose-panel';
import { RegionPanel } from './region-panel';
import { StepsPanel } from './steps-panel';

/** The side panel of the deform workspace. */
export function DeformPanels() {
  return (
    <>
      <ModelPanel />
      <StepsPanel />
      <RegionPanel />
      <HandlesPanel />
      <PosePanel />
      <MethodPanel />
      <EffectPanel />
    </>
  );
}
