# CYCLE978: titles, search words, variants.

cycle978-title = Surface
cycle978-help = Measures one point of a surface perpendicular to an axis. The probe starts opposite the surface, further away than the measuring path; the start side determines the direction.
cycle978-words = measure workpiece surface face edge plane wall point position single touch tool offset wear zero offset ZO paraxial differential probe probing pick up off finder datum work set
cycle978-each-words = one point edge face

cycle978-tool = Surface: correct a tool
cycle978-zero = Surface: correct a zero offset
cycle978-differential-tool = Surface, differential: correct a tool
cycle978-differential-zero = Surface, differential: correct a zero offset
cycle978-measured = Surface: measure only
