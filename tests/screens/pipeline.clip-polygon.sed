# The last side of the window does not cut.
s/i < window.size(); ++i/i + 1 < window.size(); ++i/
