# CYCLE116: circle through points.

cycle116-title = Circle through points
cycle116-help = Computes centre and radius of a circle from three or four points of the plane, for example from points that were measured one by one.
cycle116-words = circle centre center radius three points four points compute calculate arc hole shaft helper
cycle116-circle = Centre and radius from points
cycle116-three = Three points
cycle116-four = Four points
cycle116-no-circle = The points lie in line or upon each other; no circle goes through them.
cycle116-no-circle-hint = Choose points that are far apart on the circle, for example a third of it each.

param-116-count = Number of points
param-116-count-help = Three points determine the circle; of four all count, so that one inexact point matters less.
param-116-abscissa = Abscissa of a point
param-116-abscissa-help = Coordinate of the point in the first axis of the plane.
param-116-ordinate = Ordinate of a point
param-116-ordinate-help = Coordinate of the point in the second axis of the plane.
need-116-points = A circle takes three points at least.
need-116-fourth = Four points were chosen.

result-116-abscissa = Centre, abscissa
result-116-ordinate = Centre, ordinate
result-116-radius = Radius
result-116-status = 0: the circle was found; 1: it was not
result-116-alarm = 0, or the number of the alarm that says why there is no circle
