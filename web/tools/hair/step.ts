// The hair step's fields as tools read them.
type Point = [number, number, number];
interface Label {
  name?: string | undefined;
  hidden?: boolean | undefined;
}
export interface HairStep {
  id: string;
  type: 'hair';
  model: string;
  streams: (Label & { points: Point[]; fade: boolean })[];
  partings: (Label & { points: Point[]; tilt: [number, number]; sigma: number; height: number })[];
  ponytails: (Label & { spine: Point[]; section: Point[]; profiles: Point[][]; tightness: number })[];
}
