#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// Numbers of a row that have a name together: "colour", from 3 on, 4 of them.
struct ColumnGroup {
    std::string name;
    std::size_t first = 0;
    std::size_t size = 1;
};

/// The groups in "width, colour/4, -/2": those called "-" have no name and are left out. Nothing if the text says
/// otherwise than that, or does not name exactly `components` numbers.
[[nodiscard]] std::vector<ColumnGroup> column_groups(std::string_view text, std::size_t components);

/// What each number of a row of `value` is called: "width", "centre.x", "matrix[5]". Three or four numbers are r, g, b,
/// a where the group's name says so ("colour", "light"). Without a text that fits, rows of two to four numbers are x,
/// y, z, w, or r, g, b, a if the value's name says so, and others have no names: then there are none.
[[nodiscard]] std::vector<std::string> column_names(std::string_view text, std::size_t components,
                                                    std::string_view value);

/// What a column's name says that its values stand for: "kind" and "oblique" for 1 in "kind (0: degenerate; 1:
/// oblique)", or GL_FILL in a state of OpenGL's (gl_words.hpp). No word for other values; names that hold anything else
/// are given back as they are.
struct ColumnWord {
    std::string name;
    std::string word;
};
[[nodiscard]] ColumnWord column_word(std::string_view column, double value);

}
