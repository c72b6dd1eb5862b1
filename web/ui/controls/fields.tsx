import { useId, useRef, useState } from 'preact/hooks';
import { Button } from './button';

interface NumberProps {
  value: number;
  onChange: (value: number) => void;
  /** The edit is over: Enter, blur or the end of a scrub. */
  onCommit?: () => void;
  label: string;
  axis?: string;
  step?: number;
  min?: number;
  max?: number;
  digits?: number;
  disabled?: boolean;
}

/** A number that can be typed, stepped with the arrow keys, or scrubbed sideways with the pointer. */
export function NumberField(props: NumberProps) {
  const { value, onChange, onCommit, label, axis, step = 0.1, digits = 3, disabled } = props;
  const [typed, setTyped] = useState<string | null>(null);
  const scrub = useRef<{ x: number; from: number; moved: boolean } | null>(null);
  const clamp = (n: number) => Math.min(props.max ?? Infinity, Math.max(props.min ?? -Infinity, n));
  const shown = String(Number(value.toFixed(digits)) + 0);
  const wrong = typed !== null && !Number.isFinite(parse(typed));

  const finish = () => {
    const number = typed === null ? Number.NaN : parse(typed);
    if (typed !== shown && Number.isFinite(number)) onChange(clamp(number));
    if (typed !== null) onCommit?.();
    setTyped(null);
  };

  const input = (
    <input
      class="number"
      type="text"
      inputMode="decimal"
      aria-label={label}
      aria-invalid={wrong}
      disabled={disabled}
      value={typed ?? shown}
      onFocus={(e) => e.currentTarget.select()}
      onInput={(e) => setTyped(e.currentTarget.value)}
      onBlur={finish}
      onKeyDown={(e) => {
        if (e.key === 'Enter') {
          finish();
          e.currentTarget.select();
        } else if (e.key === 'Escape') {
          setTyped(null);
          e.currentTarget.blur();
        } else if (e.key === 'ArrowUp' || e.key === 'ArrowDown') {
          e.preventDefault();
          const by = (e.key === 'ArrowUp' ? step : -step) * (e.shiftKey ? 10 : 1);
          setTyped(null);
          onChange(clamp(value + by));
          onCommit?.();
        }
      }}
      onPointerDown={(e) => {
        if (document.activeElement === e.currentTarget || e.button !== 0) return;
        scrub.current = { x: e.clientX, from: value, moved: false };
        e.currentTarget.setPointerCapture(e.pointerId);
        e.preventDefault();
      }}
      onPointerMove={(e) => {
        const start = scrub.current;
        if (!start) return;
        const pixels = e.clientX - start.x;
        if (Math.abs(pixels) > 2) start.moved = true;
        if (start.moved) onChange(clamp(start.from + Math.round(pixels / 2) * step));
      }}
      onPointerUp={(e) => {
        const start = scrub.current;
        scrub.current = null;
        if (!start) return;
        if (start.moved) onCommit?.();
        else e.currentTarget.focus();
      }}
      onLostPointerCapture={() => {
        if (scrub.current?.moved) onCommit?.();
        scrub.current = null;
      }}
    />
  );
  if (!axis) return input;
  return (
    <span class="number-axis">
      <span aria-hidden="true">{axis}</span>
      {input}
    </span>
  );
}

/** Numbers as people type them: a decimal comma is a point. Empty text is not zero. */
function parse(text: string): number {
  const plain = text.trim().replace(',', '.');
  return plain === '' ? Number.NaN : Number(plain);
}

interface SliderProps extends Omit<NumberProps, 'axis' | 'min' | 'max'> {
  min: number;
  max: number;
}

export function SliderField(props: SliderProps) {
  const { label, value, min, max, step = (max - min) / 100, onChange, onCommit, disabled } = props;
  const id = useId();
  const filled = `${(100 * (Math.min(max, Math.max(min, value)) - min)) / (max - min || 1)}%`;
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <div class="slider">
        <input
          id={id}
          type="range"
          min={min}
          max={max}
          step={step}
          value={value}
          disabled={disabled}
          style={{ '--filled': filled }}
          onInput={(e) => onChange(e.currentTarget.valueAsNumber)}
          onChange={() => onCommit?.()}
        />
        <NumberField {...props} label={label} step={step} />
      </div>
    </div>
  );
}

interface VectorProps extends Omit<NumberProps, 'value' | 'onChange' | 'axis'> {
  value: readonly [number, number, number];
  onChange: (value: [number, number, number]) => void;
  /** What the short label leaves out, as a tooltip. */
  title?: string;
}

export function VectorField({ value, onChange, label, title, ...rest }: VectorProps) {
  return (
    <fieldset class="field vector-field" title={title}>
      <legend class="visually-hidden">{label}</legend>
      <span class="label" aria-hidden="true">
        {label}
      </span>
      <span class="vector">
        {(['X', 'Y', 'Z'] as const).map((axis, k) => (
          <NumberField
            key={axis}
            {...rest}
            axis={axis}
            label={`${label} ${axis}`}
            value={value[k]!}
            onChange={(n) => onChange(value.map((old, i) => (i === k ? n : old)) as [number, number, number])}
          />
        ))}
      </span>
    </fieldset>
  );
}

interface SwitchProps {
  label: string;
  checked: boolean;
  onChange: (checked: boolean) => void;
  disabled?: boolean;
  title?: string;
}

export function Switch({ label, checked, onChange, disabled, title }: SwitchProps) {
  return (
    <label class="switch" title={title}>
      <span>{label}</span>
      <input
        type="checkbox"
        role="switch"
        checked={checked}
        aria-checked={checked}
        disabled={disabled}
        onChange={(e) => onChange(e.currentTarget.checked)}
      />
    </label>
  );
}

interface ChoiceProps<T extends string> {
  label: string;
  value: T;
  options: readonly { readonly value: T; readonly label: string; readonly icon?: string }[];
  onChange: (value: T) => void;
}

export function SelectField<T extends string>({ label, value, options, onChange }: ChoiceProps<T>) {
  const id = useId();
  return (
    <div class="field">
      <label for={id}>{label}</label>
      <select id={id} class="select" value={value} onChange={(e) => onChange(e.currentTarget.value as T)}>
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.label}
          </option>
        ))}
      </select>
    </div>
  );
}

/** A few choices side by side, one of them taken. */
export function Segments<T extends string>({ label, value, options, onChange }: ChoiceProps<T>) {
  return (
    <fieldset class="segments" aria-label={label}>
      {options.map((option) => (
        <Button
          key={option.value}
          label={option.label}
          {...(option.icon ? { icon: option.icon } : {})}
          pressed={option.value === value}
          onClick={() => onChange(option.value)}
        />
      ))}
    </fieldset>
  );
}
