import { StepsPanel } from '../shell/steps-panel';
import { Warnings } from '../shell/warnings';
import { CurvesPanel } from './curves-panel';
import { DetailPanel } from './detail-panel';
import { GrowthPanel } from './growth-panel';
import './hair.css';
import { HeadPanel } from './head-panel';
import { LookPanel } from './look-panel';
import { ShowPanel } from './show-panel';

/** The side panel of the hair workspace. */
export function HairPanels() {
  return (
    <>
      <HeadPanel />
      <StepsPanel />
      <CurvesPanel />
      <Warnings />
      <GrowthPanel />
      <DetailPanel />
      <LookPanel />
      <ShowPanel />
    </>
  );
}
