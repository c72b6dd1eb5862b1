import type { ComponentChildren } from 'preact';
import { t } from '../../app/i18n';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { Section } from '../controls/section';

/**
 * The steps done to the model: any of them can be opened again; the later ones follow.
 * @param children  what a wing offers below the list
 */
export function StepsPanel({ children }: { children?: ComponentChildren }) {
  const { state, document } = useApp();
  const steps = state.recipe.value.steps;
  const open = state.selection.value.step;
  return (
    <Section
      title={t('ui.steps')}
      closed={steps.length < 2}
      aside={<span class="muted">{steps.length > 1 ? steps.length : ''}</span>}
    >
      <ol class="list">
        {steps.map((step, index) => (
          <li key={step.id} class={step.id === open ? 'row selected' : 'row'}>
            <button
              type="button"
              class="row-main"
              aria-current={step.id === open ? 'step' : undefined}
              onClick={() => document.openStep(step.id)}
            >
              <span class="muted">{index + 1}</span>
              <span>{step.id}</span>
            </button>
            {steps.length > 1 && (
              <Button
                icon="trash-2"
                iconOnly
                label={t('ui.steps.remove', { name: step.id })}
                onClick={() => document.removeStep(step.id)}
              />
            )}
          </li>
        ))}
      </ol>
      {children}
    </Section>
  );
}
