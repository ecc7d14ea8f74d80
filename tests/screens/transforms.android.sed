# The head turns about x instead of y: it nods.
s/turn(head_, y_axis)/turn(head_, x_axis)/
