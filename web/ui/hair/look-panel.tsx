import { t } from '../../app/i18n';
import { hairColor } from '../../core/melanin';

import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Segments, SliderField } from '../controls/fields';
import { Section } from '../controls/section';
import { usePercent } from './percent';
import { useHair } from './use-hair';

/** Natural colours by their melanin: how much, and how much of it is red. */
const SWATCHES = [
  ['white', 0.03, 0],
  ['blond', 0.25, 0.1],
  ['honey', 0.38, 0.25],
  ['ginger', 0.42, 0.85],
  ['auburn', 0.6, 0.7],
  ['brown', 0.6, 0.2],
  ['dark', 0.8, 0.15],
  ['black', 0.97, 0.05],
] as const;

/** Of a head 24 cm high, in millimetres per height. */
const MILLIMETRES = 240;

export function LookPanel() {
  const { state: own, actions: hair } = useHair();
  const { percent, length } = usePercent();
  const step = own.step.value;
  if (!step) return null;
  const { material } = step;
  const finish = () => hair.finish();
  const color = material.color ?? hairColor(material.melanin, material.redness);
  return (
    <Section title={t('ui.hair.look')}>
      <fieldset class="swatches" aria-label={t('ui.hair.swatches')}>
        {SWATCHES.map(([name, melanin, redness]) => (
          <button
            key={name}
            type="button"
            class="swatch"
            style={{ background: hairColor(melanin, redness) }}
            title={t(`ui.hair.swatch.${name}`)}
            aria-label={t(`ui.hair.swatch.${name}`)}
            aria-pressed={
              material.color === undefined && material.melanin === melanin && material.redness === redness
            }
            onClick={() => hair.update({ material: { color: undefined, melanin, redness } })}
          />
        ))}
      </fieldset>
      {material.color === undefined && (
        <>
          <SliderField
            label={t('ui.hair.melanin')}
            value={material.melanin}
            min={0}
            max={1}
            digits={2}
            onChange={(melanin) => hair.update({ material: { melanin } }, true)}
            onCommit={finish}
          />
          <SliderField
            label={t('ui.hair.redness')}
            value={material.redness}
            min={0}
            max={1}
            digits={2}
            onChange={(redness) => hair.update({ material: { redness } }, true)}
            onCommit={finish}
          />
        </>
      )}
      <div class="field">
        <label for="hair-dye">{t('ui.hair.dye')}</label>
        <span class="dye">
          <input
            id="hair-dye"
            type="color"
            value={color}
            onInput={(e) => hair.update({ material: { color: e.currentTarget.value } }, true)}
            onChange={finish}
          />
          <HexField value={color} onChange={(hex) => hair.update({ material: { color: hex } })} />
          {material.color !== undefined && (
            <Button
              icon="x"
              iconOnly
              label={t('ui.hair.dye.none')}
              onClick={() => hair.update({ material: { color: undefined } })}
            />
          )}
        </span>
      </div>
      <SliderField
        label={t('ui.hair.color-variation')}
        value={material.colorVariation}
        min={0}
        max={1}
        digits={2}
        onChange={(colorVariation) => hair.update({ material: { colorVariation } }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.thickness')}
        value={(percent(material.thickness, 8 / 240) * MILLIMETRES) / 100}
        min={0.02}
        max={0.4}
        step={0.01}
        digits={2}
        onChange={(mm) => hair.update({ material: { thickness: length((100 * mm) / MILLIMETRES) } }, true)}
        onCommit={finish}
      />
      <SliderField
        label={t('ui.hair.taper')}
        value={material.taper}
        min={0}
        max={1}
        digits={2}
        onChange={(taper) => hair.update({ material: { taper } }, true)}
        onCommit={finish}
      />
      <div class="field">
        <span class="label">{t('ui.hair.shading')}</span>
        <Segments
          label={t('ui.hair.shading')}
          value={own.shading.value}
          options={(['natural', 'kajiya-kay'] as const).map((value) => ({
            value,
            label: t(`ui.hair.shading.${value}`),
          }))}
          onChange={(shading) => {
            own.shading.value = shading;
          }}
        />
      </div>
      <div class="buttons">
        <CommandButton command="file.screenshot" kind="solid" />
      </div>
    </Section>
  );
}

/** A colour as `#rrggbb`, the sign left to taste. */
function HexField({ value, onChange }: { value: string; onChange: (hex: string) => void }) {
  return (
    <input
      key={value}
      class="text hex"
      aria-label={t('ui.hair.dye.hex')}
      defaultValue={value}
      maxLength={7}
      spellcheck={false}
      onChange={(e) => {
        const typed = /^#?([0-9a-f]{6})$/i.exec(e.currentTarget.value.trim());
        if (typed) onChange(`#${typed[1]!.toLowerCase()}`);
        else e.currentTarget.value = value;
      }}
    />
  );
}
