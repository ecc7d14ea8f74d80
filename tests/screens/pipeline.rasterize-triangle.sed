# A pixel whose centre lies on a top edge is left out.
s/return b.y < a.y || (b.y == a.y \&\& b.x > a.x)/return b.y < a.y/
