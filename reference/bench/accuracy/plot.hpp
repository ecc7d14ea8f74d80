#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::bench {

/// A point of a plot.
struct Mark {
    double x = 0;
    double y = 0;
    std::string label;   ///< written beside it where there is room; may be empty
    std::string tip;     ///< shown under the pointer or the keyboard's focus; lines end in \n
    bool knee = false;   ///< ringed, its label always shown
    bool quiet = false;  ///< drawn faintly: not on the front
};

/// Points of one kind, joined in their order if `joined` (quiet ones are left out of the line).
struct Series {
    std::string name;  ///< written at the end of the line; may be empty
    std::vector<Mark> marks;
    bool joined = true;
};

/// Both axes are logarithms; a y of 0 stands on a line of its own below all others. At most six series keep colours and
/// shapes of their own.
struct Plot {
    std::string id;     ///< unique on the page: letters, digits, hyphens
    std::string title;  ///< said by screen readers
    std::string x_label;
    std::string y_label;
    std::vector<Series> series;
    double width = 760;  ///< text is 12 pixels high in these
    double height = 430;
};

/// The plot as an SVG element, styled by the page's CSS (classes plot, grid, axis, s0 … s5, mark, knee, tip).
/// Marks whose x is not a positive number, or whose y is negative or not finite, are left out.
[[nodiscard]] std::string svg_of(const Plot& plot);

}
