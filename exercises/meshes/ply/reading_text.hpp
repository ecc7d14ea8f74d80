#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <umbral/record/ask.hpp>

namespace umbral::meshes {

/// What comes before the data: up to the line end_header, if there is one.
inline std::string_view header_of(std::string_view file)
{
    const std::size_t end = file.find("end_header\n");
    return end == std::string_view::npos ? file : file.substr(0, end + std::string_view("end_header\n").size());
}

/// A call of read_ply as code, a line of the file in a line of its own; binary data are one more. Long files are cut,
/// unless in full.
inline std::string reading_text(std::string_view file, bool in_full)
{
    const literal::Style style = in_full ? literal::in_full : literal::Style{.most_letters = 160};
    const std::size_t most_lines = in_full ? file.size() : 30;
    const bool is_binary = header_of(file).find("format binary") != std::string_view::npos;
    std::string text = "using namespace std::string_literals;\nconst std::string file =";
    std::string_view left = file;
    std::size_t lines = 0;
    for (; !left.empty() && lines < most_lines; ++lines) {
        const bool is_data = is_binary && file.size() - left.size() >= header_of(file).size();
        const std::string_view line = is_data ? left : left.substr(0, left.find('\n') + 1);
        const std::string_view piece = line.empty() ? left : line;  // a last line without an end
        text += "\n    " + literal::of_text(piece, style);
        left.remove_prefix(piece.size());
    }
    text += lines == 0 ? " \"\"s;" : "s;";
    if (!left.empty()) text += "  // … and " + std::to_string(left.size()) + " letters more";
    return text + "\nread_ply(std::as_bytes(std::span(file)))";
}

}
