// The pieces of the screen that come behind the first form, in one part: what it does, its help, data of the machine,
// and all of it on paper.

export { createHelp } from "./help";
export { createMachineData } from "./machine-data";
export { createResults } from "./results";
export { createSheet } from "./sheet";
