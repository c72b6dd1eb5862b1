import { t } from '../../app/i18n';
import { EffectPanel } from '../deform/effect-panel';
import { HandlesPanel } from '../deform/handles-panel';
import { MethodPanel } from '../deform/method-panel';
import { ModelPanel } from '../deform/model-panel';
import { PosePanel } from '../deform/pose-panel';
import { RegionPanel } from '../deform/region-panel';
import { StepsPanel } from '../deform/steps-panel';

export function SidePanel() {
  return (
    <aside class="side-panel" aria-label={t('ui.panel')}>
      <ModelPanel />
      <StepsPanel />
      <RegionPanel />
      <HandlesPanel />
      <PosePanel />
      <MethodPanel />
      <EffectPanel />
    </aside>
  );
}
