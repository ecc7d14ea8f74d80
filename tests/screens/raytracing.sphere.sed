# The interval is taken to begin at 0.
s/ray.t_min < t \&\&/0 < t \&\&/
