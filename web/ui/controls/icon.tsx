// Icons come from Lucide, as they are shipped; the set in use is listed here so that the build keeps no other.

const files = import.meta.glob<string>(
  '../../../node_modules/lucide-static/icons/{mouse-pointer-2,paintbrush,grab,circle-dot,move,rotate-3d,scale-3d,undo-2,redo-2,share-2,download,upload,folder-open,save,eye,eye-off,trash-2,x,circle-help,keyboard,command,settings,sun,moon,grid-3x3,maximize,box,layers,plus,minus,chevron-down,chevron-right,check,triangle-alert,info,circle-x,link,images,sparkles,panel-right,menu,search,rotate-ccw,copy,file-box,eraser,crosshair,flip-horizontal-2,thermometer,spline,combine,scissors,camera,loader-circle,circle,history,focus,palette,pencil,split,ribbon,user-round,dices,map-pin,highlighter,tag,person-standing,move-horizontal,move-vertical,copy-plus,bone,pen-line,play,square,unlink,feather,waves,pin,triangle,ruler,shirt,equal,sigma,lock,lock-open,chevron-up,ghost,git-compare-arrows,flag,shapes,refresh-cw,ellipsis,triangle-right,slash}.svg',
  { query: '?raw', import: 'default', eager: true },
);

const ICONS = new Map(
  Object.entries(files).map(([path, svg]) => [
    path.slice(path.lastIndexOf('/') + 1, -4),
    svg.replace(/<!--.*?-->/s, ''),
  ]),
);

/** A decorative icon: whatever it sits in carries the name. */
export function Icon({ name }: { name: string }) {
  return <span class="icon" aria-hidden="true" dangerouslySetInnerHTML={{ __html: ICONS.get(name) ?? '' }} />;
}
