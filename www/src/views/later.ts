// The pieces of the screen that come behind the first form, in one part: what it does, its help, data of the machine,
// changes before they are made, and all of it on paper.

export { createDifference } from "./difference";
export { createHelp } from "./help";
export { createMachineData } from "./machine-data";
export { createPalette } from "./palette";
export { createResults } from "./results";
export { createSheet } from "./sheet";
