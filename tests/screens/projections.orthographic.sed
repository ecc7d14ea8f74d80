# The offset in y is divided by the width of the box, as the one in x is.
s|        matrix\[3\]\[axis\] = static_cast<float>(along.offset);|        const double width = sides[0].to - sides[0].from;\n        const double size = sides[axis].to - sides[axis].from;\n        matrix[3][axis] = static_cast<float>(axis == 1 ? along.offset * size / width : along.offset);|
