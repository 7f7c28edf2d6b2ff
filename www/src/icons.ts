// The icons of the page: Lucide, in the current colour. They say nothing by themselves; whoever shows one names it.
// Each comes from its own file: the package's list of all brings 1,600 to a server that bundles nothing.

import { guard } from "lit-html/directives/guard.js";
import ArrowRight from "lucide/dist/esm/icons/arrow-right.mjs";
import Book from "lucide/dist/esm/icons/book-open.mjs";
import Box from "lucide/dist/esm/icons/box.mjs";
import Check from "lucide/dist/esm/icons/check.mjs";
import ChevronDown from "lucide/dist/esm/icons/chevron-down.mjs";
import ChevronLeft from "lucide/dist/esm/icons/chevron-left.mjs";
import ChevronRight from "lucide/dist/esm/icons/chevron-right.mjs";
import ChevronUp from "lucide/dist/esm/icons/chevron-up.mjs";
import CircleAlert from "lucide/dist/esm/icons/circle-alert.mjs";
import CircleCheck from "lucide/dist/esm/icons/circle-check.mjs";
import CircleHelp from "lucide/dist/esm/icons/circle-question-mark.mjs";
import CircleX from "lucide/dist/esm/icons/circle-x.mjs";
import Contrast from "lucide/dist/esm/icons/contrast.mjs";
import Copy from "lucide/dist/esm/icons/copy.mjs";
import Cpu from "lucide/dist/esm/icons/cpu.mjs";
import Crosshair from "lucide/dist/esm/icons/crosshair.mjs";
import Dices from "lucide/dist/esm/icons/dices.mjs";
import Download from "lucide/dist/esm/icons/download.mjs";
import Ellipsis from "lucide/dist/esm/icons/ellipsis.mjs";
import Eye from "lucide/dist/esm/icons/eye.mjs";
import FileCode from "lucide/dist/esm/icons/file-code.mjs";
import FolderOpen from "lucide/dist/esm/icons/folder-open.mjs";
import Gauge from "lucide/dist/esm/icons/gauge.mjs";
import House from "lucide/dist/esm/icons/house.mjs";
import Info from "lucide/dist/esm/icons/info.mjs";
import Joystick from "lucide/dist/esm/icons/joystick.mjs";
import Keyboard from "lucide/dist/esm/icons/keyboard.mjs";
import ListTree from "lucide/dist/esm/icons/list-tree.mjs";
import Maximize from "lucide/dist/esm/icons/maximize.mjs";
import Menu from "lucide/dist/esm/icons/menu.mjs";
import Moon from "lucide/dist/esm/icons/moon.mjs";
import Pause from "lucide/dist/esm/icons/pause.mjs";
import Play from "lucide/dist/esm/icons/play.mjs";
import Plus from "lucide/dist/esm/icons/plus.mjs";
import Printer from "lucide/dist/esm/icons/printer.mjs";
import Redo2 from "lucide/dist/esm/icons/redo-2.mjs";
import History from "lucide/dist/esm/icons/rotate-ccw-clock.mjs";
import Ruler from "lucide/dist/esm/icons/ruler.mjs";
import Save from "lucide/dist/esm/icons/save.mjs";
import Scissors from "lucide/dist/esm/icons/scissors.mjs";
import Search from "lucide/dist/esm/icons/search.mjs";
import SkipBack from "lucide/dist/esm/icons/skip-back.mjs";
import SkipForward from "lucide/dist/esm/icons/skip-forward.mjs";
import SlidersHorizontal from "lucide/dist/esm/icons/sliders-horizontal.mjs";
import StepBack from "lucide/dist/esm/icons/step-back.mjs";
import StepForward from "lucide/dist/esm/icons/step-forward.mjs";
import Sun from "lucide/dist/esm/icons/sun.mjs";
import SunMoon from "lucide/dist/esm/icons/sun-moon.mjs";
import Table from "lucide/dist/esm/icons/table.mjs";
import Trash from "lucide/dist/esm/icons/trash.mjs";
import TriangleAlert from "lucide/dist/esm/icons/triangle-alert.mjs";
import Undo2 from "lucide/dist/esm/icons/undo-2.mjs";
import Wrench from "lucide/dist/esm/icons/wrench.mjs";
import X from "lucide/dist/esm/icons/x.mjs";
import { svg } from "./dom";

const ICONS = {
  alert: CircleAlert,
  book: Book,
  calls: ListTree,
  check: Check,
  close: X,
  contrast: Contrast,
  copy: Copy,
  cut: Scissors,
  dark: Moon,
  delete: Trash,
  dice: Dices,
  down: ChevronDown,
  download: Download,
  error: CircleX,
  file: FileCode,
  first: SkipBack,
  fit: Maximize,
  gauge: Gauge,
  good: CircleCheck,
  hand: Joystick,
  help: CircleHelp,
  history: History,
  home: House,
  info: Info,
  keys: Keyboard,
  last: SkipForward,
  left: ChevronLeft,
  light: Sun,
  machine: Cpu,
  measure: Ruler,
  menu: Menu,
  more: Ellipsis,
  next: StepForward,
  open: FolderOpen,
  pause: Pause,
  perspective: Box,
  play: Play,
  previous: StepBack,
  plus: Plus,
  print: Printer,
  probe: Crosshair,
  redo: Redo2,
  right: ChevronRight,
  save: Save,
  search: Search,
  settings: SlidersHorizontal,
  solid: Box,
  start: ArrowRight,
  system: SunMoon,
  table: Table,
  tool: Wrench,
  undo: Undo2,
  up: ChevronUp,
  view: Eye,
  warning: TriangleAlert,
};

export type IconName = keyof typeof ICONS;

/** 20 px on a grid of 24. */
export function icon(name: IconName): SVGSVGElement {
  const parts = ICONS[name].map(([tag, attributes]) => svg(tag as keyof SVGElementTagNameMap, { ...attributes }));
  return svg("svg", { class: "icon", viewBox: "0 0 24 24", "aria-hidden": "true" }, ...parts);
}

/** An icon within a template: made anew only when it is another one. */
export function iconPart(name: IconName): unknown {
  return guard([name], () => icon(name));
}
