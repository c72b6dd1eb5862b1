import { useBlend } from './use-blend';

/** What a model looks like; room for it is there before it is. */
export function SkinPicture({ name }: { name: string }) {
  const picture = useBlend().state.pictures.value.get(name);
  return picture ? (
    <img class="skin-picture" src={picture} alt="" draggable={false} />
  ) : (
    <span class="skin-picture" />
  );
}
