// What the page holds for the script: the document of the run and what only pictures need.
// Lengths in mm, times in s, machine coordinates unless said otherwise.

export type Point = number[];
export type Kind = 'rapid' | 'feed' | 'skip';

export interface Call { program: string; file?: string; line?: number }
export interface CallSpan extends Call { level: number; time_s: [number, number]; blocks: [number, number] }

export interface Move { g: number; to: Point; feed?: number; t?: number; time_s?: number; file?: string; line?: number }

export interface Touch {
  block: string; file: string; line: number; triggered: boolean;
  commanded: Point; latched: Point; stopped: Point; work: Point;
  contact: Point | null; normal: Point | null; part: string | null;
  feed: number; time_s: number; calls: Call[];
}

export interface Collision {
  what: string; at: Point; work: Point; contact: Point | null; normal: Point | null; part: string | null;
  file?: string; line?: number; move: Move | null;
}

export interface LineCounts { file: string; lines: Record<string, number>; conditions?: Record<string, [number, number]> }

export interface RunDocument {
  schema: string; program?: string; status?: string; machine_time_s?: number;
  moves?: Move[]; touches?: Touch[]; calls?: CallSpan[]; counts?: LineCounts[]; collision?: Collision | null;
  alarm?: { file?: string; line?: number } | null;
}

export interface PartFigure {
  name: string; shape: string | null; sizes?: Record<string, number>; fixture?: boolean;
  origin: Point; positions: string; triangles: string;
  /** From the part's own axes to the machine's: a quaternion x y z w; without it none. */
  turn?: number[];
}

export interface Cylinder { diameter: number; length: number }
/** What holds a further ball, from the main ball's centre. */
export interface Arm { from: Point; to: Point; diameter: number }
export interface ProbeFigure {
  ball: number; offset: Point; further?: { at: Point; diameter: number }[]; arms?: Arm[]; stem: Cylinder | null; body: Cylinder | null; holder?: Cylinder | null;
}

export interface WayFigure { move: number; kind: Kind; time_s: [number, number]; points: number[];
  /** Of what carries the ball, at the beginning and the end: quaternions x y z w; without it upright. */
  turns?: [number[], number[]];
}
/** Knots of cubics: times, and three numbers each of places and speeds. */
export interface TrackFigure { times: number[]; points: number[]; speeds: number[] }
export interface TouchFigure {
  /** The ball that touched. */
  ball: Point; radius?: number;
  /** Where the axes have turned the part or the tool: in the frame of the part as it stands in the pictures. */
  contact?: Point; normal?: Point;
  deviation: number | null; part_deviation?: number | null; angle: number | null; role: string;
  /** Half of the tolerance of the size that the wall is of, into the material. */
  limits?: [number, number];
}

/** What the page calls files that the document calls alike, in the order of the document. */
export interface FileNames {
  touches: string[]; moves: string[]; calls: string[]; counts: string[]; collision: string | null;
}

export interface Figures {
  parts?: PartFigure[]; probe?: ProbeFigure | null; ways?: WayFigure[]; track?: TrackFigure; touch?: TouchFigure[];
  frame?: { name: string; origin: Point };
  /** As those of touches. */
  collision?: { contact: Point; normal: Point } | null;
  names?: FileNames | null;
  /** Of which the figures are, where the document of the page is that of another command. */
  run?: RunDocument;
  compare?: { document: RunDocument; figures: Figures } | null;
  words?: Record<string, string>; language?: string; listing?: { file: string; text: string }[];
}

/** A touch with all that figures show of it; its number counts from 1. */
export interface Contact {
  number: number; touch: Touch; time: number; hit: boolean;
  /** On the part as it stands in the pictures; the document has them where the axes stood. */
  place: Point | null; normal: Point | null;
  ball: Point | null; radius: number;
  deviation: number | null; partDeviation: number | null; angle: number | null; role: string;
  limits: [number, number] | null;
  /** Whether the measurement rests on it: no second touch of the same place follows at once. */
  counts: boolean;
}

export interface TimedMove extends Move { kind: Kind; from: number; until: number }

export interface Box { low: Point; high: Point }
export interface Part {
  name: string; fixture: boolean; origin: Point; turn: number[];
  /** Relative to origin. */
  positions: Float32Array; triangles: Uint32Array;
  /** In machine coordinates. */
  box: Box;
}

declare global {
  interface Window { g31?: RunDocument; g31Timing?: Record<string, number> }
}
