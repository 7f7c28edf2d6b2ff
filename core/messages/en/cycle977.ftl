# CYCLE977: titles, search words, variants.

cycle977-title = Hole, shaft, groove, web, rectangle
cycle977-help = Measures size and centre parallel to the axes, from the setpoint centre: two touches for groove or web, four otherwise. Corrects a tool, a zero offset, or nothing.
cycle977-words = measure workpiece hole bore shaft boss groove slot web rib pocket island rectangle rectangular diameter width centre center inside outside tool offset wear zero offset ZO paraxial protection zone safety zone probe probing datum work dowel set

cycle977-hole-tool = Hole: correct a tool
cycle977-shaft-tool = Shaft: correct a tool
cycle977-groove-tool = Groove: correct a tool
cycle977-web-tool = Web: correct a tool
cycle977-pocket-tool = Inside rectangle: correct a tool
cycle977-island-tool = Outside rectangle: correct a tool
cycle977-hole-zero = Hole: correct a zero offset
cycle977-shaft-zero = Shaft: correct a zero offset
cycle977-groove-zero = Groove: correct a zero offset
cycle977-web-zero = Web: correct a zero offset
cycle977-pocket-zero = Inside rectangle: correct a zero offset
cycle977-island-zero = Outside rectangle: correct a zero offset
cycle977-hole-zone-tool = Hole, with protection zone: correct a tool
cycle977-shaft-zone-tool = Shaft, with protection zone: correct a tool
cycle977-groove-zone-tool = Groove, with protection zone: correct a tool
cycle977-web-zone-tool = Web, with protection zone: correct a tool
cycle977-pocket-zone-tool = Inside rectangle, with protection zone: correct a tool
cycle977-island-zone-tool = Outside rectangle, with protection zone: correct a tool
cycle977-hole-zone-zero = Hole, with protection zone: correct a zero offset
cycle977-shaft-zone-zero = Shaft, with protection zone: correct a zero offset
cycle977-groove-zone-zero = Groove, with protection zone: correct a zero offset
cycle977-web-zone-zero = Web, with protection zone: correct a zero offset
cycle977-pocket-zone-zero = Inside rectangle, with protection zone: correct a zero offset
cycle977-island-zone-zero = Outside rectangle, with protection zone: correct a zero offset
