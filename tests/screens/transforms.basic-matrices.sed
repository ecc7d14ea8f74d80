# The last factor of a scaling is forgotten.
s/for (int i = 0; i < 3; ++i) m\[i\]\[i\]/for (int i = 0; i < 2; ++i) m[i][i]/
