import type { Command } from '../../commands';
import type { CurvesActions } from '../actions';
import type { CurvesState } from '../state';

/** What the contour tool offers beside itself. */
export function contourCommands({ contours }: CurvesState, { hand }: CurvesActions): Command[] {
  const shared = { group: 'curves', workspace: 'curves' } as const;
  const isOn = () => contours.on.value;
  return [
    {
      ...shared,
      id: 'curves.contours.suggestive',
      title: 'command.curves.contours.suggestive',
      icon: 'waves',
      enabled: isOn,
      checked: () => contours.suggestive.value,
      run: () => {
        contours.suggestive.value = !contours.suggestive.peek();
      },
    },
    {
      ...shared,
      id: 'curves.contours.beside',
      title: 'command.curves.contours.beside',
      icon: 'pin',
      enabled: isOn,
      checked: () => contours.beside.value,
      run: () => {
        contours.beside.value = !contours.beside.peek();
        hand.settle('beside');
      },
    },
    {
      ...shared,
      id: 'curves.contours.let-go',
      title: 'command.curves.contours.let-go',
      enabled: () => isOn() && contours.hand.value !== null,
      run: () => {
        hand.letGo();
      },
    },
    {
      ...shared,
      id: 'curves.contours.again',
      title: 'command.curves.contours.again',
      icon: 'rotate-ccw',
      enabled: () => isOn() && (contours.problem.value === 'stopped' || contours.problem.value === 'failed'),
      run: () => {
        contours.problem.value = null;
      },
    },
  ];
}
