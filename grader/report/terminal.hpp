#pragma once

#include <string>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// How a report looks. No line exceeds the width, except commands, which stay whole so that they can be copied.
struct TerminalStyle {
    bool color = false;           ///< ANSI colours; what a colour says is always said in words or marks too
    bool unicode = true;          ///< UTF-8 marks and frames; otherwise the whole report is ASCII
    int width = 100;              ///< cells of a line; less than 60 counts as 60
    std::string folder{};         ///< the workspace, for commands that are proposed; empty: where one stands
    std::string language = "en";  ///< reserved: "en" or "es"
};

/// What a student reads after a check: a line for each unit, the total, and for each unit that is not all right its
/// first failing check with the student's value beside the expected one, the likely reason, what the code printed, and
/// how to go on.
///
/// Of hidden checks only name, points and verdict are shown (without_hidden_values). All text from outside is escaped.
/// Equal results give equal reports but for times.
[[nodiscard]] std::string terminal_report(const SubmissionResult& submission, const TerminalStyle& style);

/// What stands above that table: whose points are in no sum and why, once for each cause, and what is unfinished, with
/// what to do about it. Empty if there is nothing.
[[nodiscard]] std::string class_notices(const ClassResult& result, const TerminalStyle& style);

/// What an instructor reads: submissions down, units across, each cell a mark and points, the total, and the mean of
/// each column.
///
/// Names are shortened to fit; where even that is too wide units are numbered, with the names below, and where there
/// are too many the table continues in further bands. All rows of a band have the same width.
[[nodiscard]] std::string class_table(const ClassResult& result, const TerminalStyle& style);

}
