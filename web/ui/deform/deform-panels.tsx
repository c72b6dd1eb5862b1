import { CommandButton } from '../controls/command-button';
import { ModelPanel } from '../shell/model-panel';
import { StepsPanel } from '../shell/steps-panel';
import { EffectPanel } from './effect-panel';
import { HandlesPanel } from './handles-panel';
import { MethodPanel } from './method-panel';
import { PosePanel } from './pose-panel';
import { RegionPanel } from './region-panel';

/** The side panel of the deform workspace. */
export function DeformPanels() {
  return (
    <>
      <ModelPanel />
      <StepsPanel>
        <CommandButton command="step.apply" kind="solid" />
      </StepsPanel>
      <RegionPanel />
      <HandlesPanel />
      <PosePanel />
      <MethodPanel />
      <EffectPanel />
    </>
  );
}
