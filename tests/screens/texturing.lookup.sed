# The centres of texels lie at their corners in one direction.
s/std::floor(y - 0.5)/std::floor(y)/; s/y - 0.5 - below/y - below/
