import { useState } from 'preact/hooks';
import { t } from '../../app/i18n';
import { standsIn } from '../../recipe/steps/curves-poses';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { SelectField, SliderField } from '../controls/fields';
import { Section } from '../controls/section';
import { useCurves } from './use-curves';

/** Poses that are kept: taken up by a click, blended by a slider, played one after the other. */
export function PosesPanel() {
  const { state: own } = useCurves();
  const step = own.step.value;
  if (!step || step.curves.length === 0) return null;
  return (
    <Section title={t('ui.curves.poses')}>
      {step.poses.length === 0 && <p class="muted">{t('ui.curves.poses.none')}</p>}
      <ul class="list" aria-label={t('ui.curves.poses')}>
        {step.poses.map((pose, at) => (
          <Row key={`${at} ${pose.name}`} at={at} />
        ))}
      </ul>
      <div class="buttons">
        <CommandButton command="curves.add-pose" kind="solid" />
        {step.poses.length > 1 && <CommandButton command="curves.play" kind="solid" />}
      </div>
      {step.poses.length > 1 && !own.playing.value && <Blend />}
    </Section>
  );
}

/** What lies between two poses. */
function Blend() {
  const { state: own, actions: curves } = useCurves();
  const [between, setBetween] = useState({ from: 0, to: 1, share: 0 });
  const poses = own.step.value?.poses ?? [];
  const options = poses.map(({ name }, at) => ({ value: String(at), label: name }));
  const [from, to] = [between.from, between.to].map((at) => Math.min(at, poses.length - 1)) as [
    number,
    number,
  ];
  return (
    <>
      <SelectField
        label={t('ui.curves.blend.from')}
        value={String(from)}
        options={options}
        onChange={(at) => setBetween({ ...between, from: Number(at), share: 0 })}
      />
      <SelectField
        label={t('ui.curves.blend.to')}
        value={String(to)}
        options={options}
        onChange={(at) => setBetween({ ...between, to: Number(at), share: 0 })}
      />
      <SliderField
        label={t('ui.curves.blend')}
        value={100 * between.share}
        min={0}
        max={100}
        step={1}
        digits={0}
        onChange={(percent) => {
          setBetween({ ...between, share: percent / 100 });
          curves.blend(from, to, percent / 100);
        }}
        onCommit={() => curves.edits.finish()}
      />
    </>
  );
}

/** Room for it is there before it is. */
function Picture({ of }: { of: string | undefined }) {
  return of ? <img class="pose-picture" src={of} alt="" /> : <span class="pose-picture" />;
}

function Row({ at }: { at: number }) {
  const [renaming, setRenaming] = useState(false);
  const { state: own, actions: curves } = useCurves();
  const step = own.step.value;
  const pose = step?.poses[at];
  if (!step || !pose) return null;
  const taken = standsIn(step, pose);
  return (
    <li class={taken ? 'row selected' : 'row'}>
      {renaming ? (
        <input
          class="text"
          aria-label={t('ui.item.rename', { name: pose.name })}
          value={pose.name}
          maxLength={64}
          ref={(input) => input?.focus()}
          onBlur={(e) => {
            setRenaming(false);
            curves.renamePose(at, e.currentTarget.value);
          }}
          onKeyDown={(e) => {
            if (e.key === 'Escape') e.currentTarget.value = pose.name;
            if (e.key === 'Enter' || e.key === 'Escape') e.currentTarget.blur();
          }}
        />
      ) : (
        <button
          type="button"
          class="row-main"
          aria-pressed={taken}
          onClick={() => curves.takePose(at)}
          onDblClick={() => setRenaming(true)}
        >
          <Picture of={curves.picture(pose)} />
          <span>{pose.name}</span>
        </button>
      )}
      <Button
        icon="pencil"
        iconOnly
        label={t('ui.item.rename', { name: pose.name })}
        onClick={() => setRenaming(true)}
      />
      <Button
        icon="trash-2"
        iconOnly
        label={t('ui.item.remove', { name: pose.name })}
        onClick={() => curves.removePose(at)}
      />
    </li>
  );
}
