// The pieces of the screen that come behind the first form, in one part: what it does, its help, data of the machine,
// changes before they are made, and all of it on paper.

export { createChain } from "./chain";
export { createDifference } from "./difference";
export { createEquipment } from "./equipment";
export { createHelp } from "./help";
export { createMachineData } from "./machine-data";
export { createPalette } from "./palette";
export { createPaper } from "./paper";
export { createResults } from "./results";
export { createSheet } from "./sheet";
