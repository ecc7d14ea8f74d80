#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// A line of a statement's table "What is checked".
struct StatementLine {
    std::string name;  ///< of one case or of several, as "far, near (hidden)"
    std::string text;  ///< what is judged, in one line, without marks of links
};

/// The lines of the table below the heading "## What is checked", in their order; none if there is no such table.
/// A text that begins with "the same" or "likewise" has that of the line above before it: it is read alone.
[[nodiscard]] std::vector<StatementLine> statement_lines(std::string_view statement);

/// What the statement says of a check: of the line that is called as its case ("far"), as case and value ("far/t" or
/// "far: t", "far: t, index"), or that names the case among others. Empty if there is none, or if the lines about the
/// case are about other values.
[[nodiscard]] std::string statement_says(const std::vector<StatementLine>& lines, std::string_view case_name,
                                         std::string_view value);

}
