# CYCLE116: circle through points.

cycle116-title = Circle through points
cycle116-help = Calculates centre and radius of a circle from three or four points in the plane, for example from points measured one by one.
cycle116-words = circle centre center radius three points four points compute calculate arc hole shaft helper
cycle116-circle = Centre and radius from points
cycle116-three = Three points
cycle116-four = Four points
cycle116-no-circle = The points are collinear or coincident: no circle can be calculated.
cycle116-no-circle-hint = Choose points far apart on the circle, for example a third of the circumference apart.

param-116-count = Number of points
param-116-count-help = Three points determine the circle; with four, all are used, so one inaccurate point has less influence.
param-116-abscissa = Abscissa of a point
param-116-abscissa-help = Coordinate of the point in the 1st axis of the plane.
param-116-ordinate = Ordinate of a point
param-116-ordinate-help = Coordinate of the point in the 2nd axis of the plane.
need-116-points = A circle needs at least three points.
need-116-fourth = Four points are selected.

result-116-abscissa = Centre, abscissa
result-116-ordinate = Centre, ordinate
result-116-radius = Radius
result-116-status = 0: circle calculated; 1: no circle
result-116-alarm = 0, or alarm number if no circle
