#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::bench {

struct Box {
    double left;
    double top;
    double right;
    double bottom;
};

/// Where a text begins: left end of its base line.
struct Place {
    double x;
    double y;
};

/// The end of a line that wants its name beside it.
struct NamedEnd {
    std::string name;
    double x;
    double y;
};

/// The width of a text of 12 pixels, in pixels: an estimate on the safe side.
[[nodiscard]] double text_width(std::string_view text);

/// Finds room for texts in a picture: none overlaps another, a mark, or the border.
class Labels {
public:
    explicit Labels(Box inside) : inside_(inside) {}

    /// No label shall cover this point and what lies within `radius` of it.
    void keep_free(double x, double y, double radius);

    /// A place beside a point: right, left, above or below; none if all are taken. If `always`, the first that only
    /// covers lesser things.
    [[nodiscard]] std::optional<Place> beside(double x, double y, const std::string& text, bool always);

    /// Places left or right of the ends of lines, pushed apart so that none covers another; in the order of `ends`.
    [[nodiscard]] std::vector<Place> name_ends(const std::vector<NamedEnd>& ends, bool at_left);

private:
    [[nodiscard]] bool is_free(const Box& box) const;

    Box inside_;
    std::vector<Box> taken_;
};

}
