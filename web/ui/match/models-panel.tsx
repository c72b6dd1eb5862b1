import { formatNumber, t } from '../../app/i18n';
import { POSED_BY } from '../../app/match/models';
import { wings } from '../../app/wings';
import { vertexCount } from '../../core/model';
import { useApp } from '../context';
import { Button } from '../controls/button';
import { CommandButton } from '../controls/command-button';
import { Menu } from '../controls/menu';
import { Section } from '../controls/section';
import { useMatch } from './use-match';

/** The models in their order; the skins are made of the first. */
export function ModelsPanel() {
  const { state } = useApp();
  const { state: own } = useMatch();
  const step = own.step.value;
  const names = step?.models ?? own.models.value.map(({ model }) => model.name);
  return (
    <Section
      title={t('ui.match.models')}
      aside={!state.choosing.value && <CommandButton command="match.add" iconOnly />}
    >
      <ul class="list" aria-label={t('ui.match.models')}>
        {names.map((name, at) => (
          <Row key={name} name={name} at={at} />
        ))}
      </ul>
    </Section>
  );
}

function Row({ name, at }: { name: string; at: number }) {
  const { state } = useApp();
  const { state: own, actions: match } = useMatch();
  const model = own.models.value[at]?.model;
  const count = own.step.value?.models.length ?? 0;
  return (
    <li class="row match-model">
      <span class="row-main">
        <span class="match-number">{at + 1}</span>
        <span class="model-name">{name}</span>
        {at === 0 && <span class="muted match-first">{t('ui.match.source')}</span>}
        <span class="muted count" title={model && t('ui.figure.vertices', { count: vertexCount(model) })}>
          {model && formatNumber(vertexCount(model))}
        </span>
      </span>
      {own.step.value && !state.choosing.value && (
        <Menu label={t('ui.match.model.menu', { name })} icon="ellipsis" iconOnly align="end">
          <Button
            role="menuitem"
            icon="flag"
            label={t('ui.match.model.source')}
            disabled={at === 0}
            onClick={() => match.models.makeSource(at)}
          />
          <Button
            role="menuitem"
            icon="box"
            label={t('ui.match.model.replace')}
            onClick={() => match.models.replace(at)}
          />
          {POSED_BY.map((by) => (
            <Button
              key={by}
              role="menuitem"
              icon={wings[by].icon}
              label={t(`ui.match.pose.${by}`)}
              onClick={() => match.pose(at, by)}
            />
          ))}
          <Button
            role="menuitem"
            icon="x"
            label={t('ui.match.model.remove')}
            disabled={count <= 2}
            onClick={() => match.models.remove(at)}
          />
        </Menu>
      )}
    </li>
  );
}
