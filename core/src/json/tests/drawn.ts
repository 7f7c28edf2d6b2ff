
// What is drawn of a run, and the setup file: described by hand (core/src/json/tests/drawn.ts), as they are written by
// hand.

export type Vec3 = [number, number, number];

/** Centre and radius, mm. */
export interface Circle {
  x: number;
  y: number;
  r: number;
}

export type MotionKind = "rapid" | "positioning" | "measuring" | "retract";

/** A way round an axis, right-handed; absent: straight. Between different heights it climbs evenly. */
export interface Around {
  centre: Vec3;
  axis: Vec3;
  degrees: number;
}

/** What of the probe touches; where it is left out, the ball. */
export type Touching = "ball" | "stylus" | "body";

export type Step =
  | { step: "motion"; kind: MotionKind; from: Vec3; to: Vec3; feed: number; around?: Around }
  | { step: "touch"; latched: Vec3; ball: Vec3; point: Vec3; normal: Vec3; by?: Touching }
  | { step: "crash"; point: Vec3; normal: Vec3; by?: Touching }
  | { step: "orient"; angle: number }
  | { step: "spin"; speed: number } // 1/min, negative as M4; 0: it stops
  | { step: "table"; axis: string; from: number; to: number; solids: Solid[] } // the part as it stands then
  | { step: "tool"; tool: number; edge: number }
  | { step: "set"; name: string; before: number; after: number }
  | { step: "decision"; message: Message }
  | { step: "alarm"; code: string; message: Message; hint?: Message; stops: boolean }
  | { step: "message"; text: string }
  | { step: "log"; text: string }
  | { step: "call"; cycle: string; variant: number }
  | { step: "return" };

// ball.stylus: radius above the ball; body: what holds it, where that is known, and the distance of its lower face.
// tools: whatever was in use; inUse: which of them from which entry on, absent: a ball that stands upright.
// zones: walls of protection zones, as shaft, web or island; shown, not touched.
// limits: the part with the largest errors on both sides.
/** A coordinate system, by the name of its zero offset; `moved`: by a correction. */
export interface FrameView {
  name: string;
  at: Vec3;
  axes: [Vec3, Vec3, Vec3];
  moved?: "before" | "after";
}

export interface Trace {
  entries: (Step & { line?: number })[];
  ball: Ball;
  tools?: ToolView[];
  inUse?: [from: number, tool: number][];
  turning?: boolean;
  drawing?: Drawing;
  solids: Solid[];
  toolProbes?: Solid[];
  zones?: Solid[];
  limits?: Solid[];
  frames: FrameView[];
}

export interface Ball {
  radius: number;
  length: number;
  stylus?: number;
  body?: { radius: number; distance: number };
}

/** What is in use, from the position of the machine on: the ball of the probe or the pieces of a tool. */
export interface ToolView {
  length: Vec3; // in effect, along X Y Z: where it changes, the axes stand still
  ball?: Vec3; // direction from the ball to what holds it; absent: no probe
  pieces: ToolPiece[];
  carrier: ToolPiece[]; // what holds it on a turning machine
  tip: Vec3; // its end
}

/**
 * Half of a section turned about an axis: distance from it and height; or a convex flat piece, with its thickness.
 * cuts: an insert.
 */
export type ToolPiece = { cuts?: boolean } & (
  | { outline: [number, number][]; axis: Vec3; at: Vec3 }
  | { corners: Vec3[]; thick: Vec3 }
);

/**
 * A turned part as on a drawing. ends: of a diameter as it is; out: along the axis, away from the part; touched:
 * diameters as the control reads them.
 */
export interface Drawing {
  diameters: { ends: [Vec3, Vec3]; out: Vec3; set: number; real: number }[];
  touched: { entry: number; diameter: number }[];
  // where positions count from, and whether X is a diameter
  reading: { at: Vec3; axes: [Vec3, Vec3, Vec3]; diameter: boolean };
}

export interface Solid {
  shape:
    | "hole"
    | "shaft"
    | "groove"
    | "web"
    | "pocket"
    | "island"
    | "block"
    | "turned"
    | "chuck"
    | "sphere"
    | "outerCorner"
    | "innerCorner"
    | "surface";
  // hole [diameter, depth]; shaft [diameter, height]; groove/web [width, depth, length]; pocket/island [x, y, depth];
  // block [x, y, z]; turned [diameter, length, bore, its depth]; chuck [diameter, length, diameter gripped]; sphere
  // [diameter]; outerCorner/innerCorner [degrees between the edges, edge along X, other edge, z]
  size: number[];
  surface?: Surface; // of the shape "surface", which has no size
  at: Vec3;
  rotation: Vec3; // mm; RPY degree
  errors: { shift: Vec3; size: number; tilt: Vec3; taper: number; outOfRound: [number, number] };
}

/** Heights in rows along X over a grid about the origin, or single triangles. */
export type Surface =
  | { heights: { columns: number; step: [number, number]; values: number[] } }
  | { triangles: [Vec3, Vec3, Vec3][] };

// Setup: docs/setup.schema.json is its schema; also what the terminal reads and the page exports.
export interface Setup {
  control: Dialect;
  units: BasicSystem;
  plane: Plane;
  active?: {
    tool?: number;
    edge?: number;
    frame?: string;
    units?: UnitFunction;
    transverse?: Transverse;
    spindle?: number;
  }; // in force at the start
  machine?: { limitsMinus?: (number | null)[]; limitsPlus?: (number | null)[]; spindlePositions?: boolean };
  tools: Record<
    string,
    {
      name?: string;
      edges: Record<
        string,
        {
          type: number;
          length: Vec3;
          radius: number;
          lengthWear?: Vec3;
          radiusWear?: number;
          additive?: Record<string, number[]>;
          setup?: Record<string, number[]>;
          real?: RealTool;
        }
      >;
    }
  >;
  frames: Record<string, { coarse: Vec3; fine?: Vec3; rotation?: Vec3; scale?: Vec3 }>; // "G54"
  environments?: Record<string, { tool: number; edge: number; location?: number; plane?: Plane }>; // of TOOLENV("NAME")
  data: Record<string, number | string>; // "_WP[0,1]", "_CHBIT[4]", "MD18600", "R10", "#500"
  probe: {
    radius: number;
    length: number;
    skew?: [number, number];
    preTravel?: [number, number];
    delay?: number;
    repeatability?: [number, number];
    falseSignal?: number;
    stylus?: number;
    body?: { radius: number; distance: number };
  };
  // block or turned
  toolProbes?: { solid: Solid; preTravel?: number; delay?: number; repeatability?: [number, number] }[];
  workpiece: Solid[];
  position?: Vec3; // at the start, machine coordinates
  skip?: number[]; // levels switched on: blocks with /, /1.. are left out
}

/** A tool as it is where it touches a tool probe; runoutAngle and angle in degree with the spindle at 0. */
export interface RealTool {
  length: Vec3; // L1 L2 L3
  cut:
    | {
        cutter: {
          radius: number;
          corner?: number;
          chamfer?: [number, number];
          teeth?: number;
          angle?: number;
          runout?: [number, number];
          runoutAngle?: number;
          axis?: number;
        };
      }
    | { nose: { radius: number; side: [number, number] } };
}

// A value changed in the form and not yet in the program: of the call that begins at UTF-16 offset `at` there. asks: it
// would change these lines of that text outside of its call, and waits for a word; agreed: that was given.
export interface Pending {
  control: Dialect;
  at: number;
  name: string;
  value: string;
  asks?: { text: string; lines: TouchedLine[] };
  agreed?: boolean;
}
