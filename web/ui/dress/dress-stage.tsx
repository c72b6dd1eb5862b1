import { t, tCode } from '../../app/i18n';
import { useApp } from '../context';
import { Icon } from '../controls/icon';
import { ModelChooser } from '../shell/model-chooser';
import { Pane } from '../shell/panes';
import { useDress } from './use-dress';

/** The body that the garment was made for, to the left of the one that gets it. */
export function DressStage() {
  const { state } = useApp();
  const { state: own, actions: dress } = useDress();
  const source = own.source.value;
  const choosing = state.choosing.value !== null;
  return (
    <>
      <Pane index={0} class="beside">
        {source && (
          <p class="pane-label">
            <span class="muted">{t('ui.dress.from')}</span>{' '}
            {choosing ? source.model.name : (own.step.value?.from ?? source.model.name)}
          </p>
        )}
      </Pane>
      <div class="pane over-main">
        {choosing ? (
          <ModelChooser
            title={t('ui.dress.choose')}
            help={t('ui.dress.choose.help')}
            first={({ worn }) => worn === true}
            onCancel={() => dress.choice.cancel()}
          />
        ) : (
          <Labels />
        )}
      </div>
    </>
  );
}

/** Who is on screen, and what there is to say of it. */
function Labels() {
  const { state } = useApp();
  const { state: own } = useDress();
  const name = own.step.value?.to;
  const problem = own.problem.value;
  const told = [
    ...(problem ? [problem] : []),
    ...state.warnings.value.map(({ code, count }) => tCode('finding.', code, 'finding.unknown', { count })),
  ];
  return (
    <div class="main-labels">
      {name !== undefined && (
        <p class="pane-label">
          <span class="muted">{t('ui.dress.to')}</span> {name}
        </p>
      )}
      {told.map((text) => (
        <p key={text} class="pane-label warn" role="alert">
          <Icon name="triangle-alert" />
          {text}
        </p>
      ))}
    </div>
  );
}
