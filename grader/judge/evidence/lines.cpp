#include <fmt/format.h>

#include <algorithm>

#include "judge/evidence/kinds.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_shown = 120;  // rows of the table
constexpr std::size_t context = 2;       // equal lines kept beside a difference

LinePair same_lines(const Sides& sides, std::size_t a, std::size_t b)
{
    return {LineKind::same, sides.first_number + a, sides.first_number + b, sides.yours[a], sides.expected[b], 0};
}

/// What lies between two matches: lines of both sides pair up in their order, the rest is missing or extra.
void add_gap(const Sides& sides, std::size_t a, std::size_t a_end, std::size_t b, std::size_t b_end,
             LinesEvidence& result)
{
    for (; a < a_end || b < b_end;) {
        const bool both = a < a_end && b < b_end;
        LinePair line;
        line.kind = both ? LineKind::changed : a < a_end ? LineKind::extra : LineKind::missing;
        ++(both ? result.changed : a < a_end ? result.extra : result.missing);
        if (a < a_end) line.yours = sides.yours[a], line.yours_number = sides.first_number + a++;
        if (b < b_end) line.expected = sides.expected[b], line.expected_number = sides.first_number + b++;
        result.lines.push_back(std::move(line));
    }
}

/// Long runs of equal lines shrink to their ends and a count.
std::vector<LinePair> folded(std::vector<LinePair> lines)
{
    std::vector<LinePair> result;
    for (std::size_t start = 0; start < lines.size();) {
        std::size_t end = start;
        while (end < lines.size() && lines[end].kind == LineKind::same) ++end;
        const std::size_t before = start == 0 ? 0 : context;
        const std::size_t after = end == lines.size() ? 0 : context;
        if (end - start > before + after + 1) {
            const auto from = lines.begin() + static_cast<std::ptrdiff_t>(start);
            std::move(from, from + static_cast<std::ptrdiff_t>(before), std::back_inserter(result));
            LinePair omitted;
            omitted.kind = LineKind::omitted;
            omitted.omitted = end - start - before - after;
            result.push_back(std::move(omitted));
            start = end - after;
        }
        while (start < end) result.push_back(std::move(lines[start++]));
        if (end < lines.size()) result.push_back(std::move(lines[end]));
        start = end + 1;
    }
    return result;
}

}

LinesEvidence lines_evidence(const Sides& sides, std::string what, bool cut)
{
    LinesEvidence result;
    result.what = std::move(what);
    std::size_t a = 0;
    std::size_t b = 0;
    for (const auto& [match_a, match_b] : sides.alignment.matches) {
        add_gap(sides, a, match_a, b, match_b, result);
        result.lines.push_back(same_lines(sides, match_a, match_b));
        a = match_a + 1;
        b = match_b + 1;
    }
    add_gap(sides, a, sides.yours.size(), b, sides.expected.size(), result);
    result.lines = folded(std::move(result.lines));
    result.cut = cut || result.lines.size() > most_shown;
    if (result.lines.size() > most_shown) result.lines.resize(most_shown);
    return result;
}

}
