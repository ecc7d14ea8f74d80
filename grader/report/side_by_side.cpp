#include "report/side_by_side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "report/layout.hpp"

namespace umbral::grader {
namespace {

constexpr int gap = 4;

std::optional<double> number_in(const std::string& text)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

bool same_shape(const MatrixText& a, const MatrixText& b)
{
    return a.size() == b.size() && a.front().size() == b.front().size();
}

std::size_t fraction_of(const std::string& entry)
{
    return entry.size() - std::min(entry.size(), entry.find_first_of(".e"));
}

/// Entries of each column with their decimal points below each other.
void align_points(MatrixText& matrix)
{
    for (std::size_t column = 0; column < matrix.front().size(); ++column) {
        std::size_t fraction = 0;
        int width = 0;
        for (const auto& row : matrix) fraction = std::max(fraction, fraction_of(row[column]));
        for (auto& row : matrix) {
            row[column] += std::string(fraction - fraction_of(row[column]), ' ');
            width = std::max(width, display_width(row[column]));
        }
        for (auto& row : matrix) row[column] = pad(row[column], width, Align::right);
    }
}

std::vector<std::string> drawn(MatrixText matrix, const std::vector<std::vector<bool>>& differs, Tone tone,
                               const Paint& paint)
{
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (std::size_t j = 0; j < matrix[i].size(); ++j)
            matrix[i][j] = fmt::format("{}{}", differs[i][j] ? paint.symbol("▸", ">") : " ", paint.safe(matrix[i][j]));
    align_points(matrix);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        const bool first = i == 0;
        const bool last = i + 1 == matrix.size();
        std::string line(first ? paint.symbol("⎡", "[") : last ? paint.symbol("⎣", "[") : paint.symbol("⎢", "["));
        for (std::size_t j = 0; j < matrix[i].size(); ++j)
            line += fmt::format(" {}", paint(differs[i][j] ? tone : Tone::quiet, matrix[i][j]));
        line += " ";
        line += first ? paint.symbol("⎤", "]") : last ? paint.symbol("⎦", "]") : paint.symbol("⎥", "]");
        lines.push_back(line);
    }
    return lines;
}

int widest(const std::vector<std::string>& lines)
{
    int width = 0;
    for (const std::string& line : lines) width = std::max(width, display_width(line));
    return width;
}

std::vector<std::string> text_lines(const std::string& text, int width, Tone tone, const Paint& paint)
{
    constexpr std::size_t most = 12;
    std::vector<std::string> lines = wrap(paint.safe_lines(text), width);
    if (lines.empty()) lines.emplace_back("(nothing)");
    if (lines.size() > most) {
        lines.resize(most);
        lines.emplace_back(paint.ellipsis());
    }
    for (std::string& line : lines) line = paint(tone, line);
    return lines;
}

}

std::optional<MatrixText> find_matrix(std::string_view text)
{
    const std::size_t open = text.find('[');
    const std::size_t close = text.find(']', open == std::string_view::npos ? 0 : open);
    if (open == std::string_view::npos || close == std::string_view::npos) return std::nullopt;
    std::istringstream rows{std::string(text.substr(open + 1, close - open - 1))};
    MatrixText matrix;
    for (std::string row; std::getline(rows, row, ';');) {
        std::istringstream entries(row);
        auto& target = matrix.emplace_back();
        for (std::string entry; entries >> entry;) target.push_back(entry);
        if (target.empty() || target.size() != matrix.front().size()) return std::nullopt;
    }
    if (matrix.size() < 2) return std::nullopt;
    return matrix;
}

std::vector<std::vector<bool>> differing_entries(const MatrixText& yours, const MatrixText& expected)
{
    std::vector<std::vector<double>> distance(yours.size());
    double largest = 0;
    for (std::size_t i = 0; i < yours.size(); ++i)
        for (std::size_t j = 0; j < yours[i].size(); ++j) {
            const auto a = number_in(yours[i][j]);
            const auto b = number_in(expected[i][j]);
            const double apart = a && b ? std::abs(*a - *b) : yours[i][j] == expected[i][j] ? 0 : INFINITY;
            distance[i].push_back(apart);
            if (std::isfinite(apart)) largest = std::max(largest, apart);
        }
    std::vector<std::vector<bool>> differs(yours.size());
    for (std::size_t i = 0; i < yours.size(); ++i)
        for (const double apart : distance[i]) differs[i].push_back(apart > largest / 100);
    return differs;
}

std::vector<std::string> side_by_side(const Difference& difference, int width, const Paint& paint)
{
    std::vector<std::string> left;
    std::vector<std::string> right;
    const auto yours = find_matrix(difference.yours);
    const auto expected = find_matrix(difference.expected);
    if (yours && expected && same_shape(*yours, *expected)) {
        const auto differs = differing_entries(*yours, *expected);
        left = drawn(*yours, differs, Tone::yours, paint);
        right = drawn(*expected, differs, Tone::expected, paint);
    } else {
        const int half = (width - gap) / 2;
        left = text_lines(difference.yours, half, Tone::yours, paint);
        right = text_lines(difference.expected, half, Tone::expected, paint);
    }
    left.insert(left.begin(), paint(Tone::quiet, "yours"));
    right.insert(right.begin(), paint(Tone::quiet, "expected"));

    const int left_width = std::max(widest(left), 16);
    if (left_width + gap + widest(right) > width) {
        left.insert(left.end(), right.begin(), right.end());
        return left;
    }
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
        const std::string begin = i < left.size() ? left[i] : "";
        lines.push_back(i < right.size() ? pad(begin, left_width + gap) + right[i] : begin);
    }
    return lines;
}

}
