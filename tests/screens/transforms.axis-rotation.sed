# The sine has the wrong sign.
s/std::sin(/-std::sin(/
