#include "manifest/marks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace umbral::grader {
namespace {

constexpr double most_points = 1000;

}

Millipoints read_points(const Field& field)
{
    const double thousandths = field.number(0, most_points) * 1000;
    // 0.001 is no binary fraction: what was written with three places comes within a few roundings of a whole number.
    if (thousandths < 0.5 || std::abs(thousandths - std::round(thousandths)) > 1e-6)
        field.refuse("points above 0 with at most 3 decimal places");
    return std::llround(thousandths);
}

std::vector<RubricLine> read_rubric(const Field& field)
{
    std::vector<RubricLine> lines;
    if (!field.given()) return lines;
    for (const Field& item : field.items(1, 64)) {
        item.allow_only({"words", "points"});
        lines.push_back({item.member("words").text(200), read_points(item.member("points"))});
    }
    return lines;
}

std::size_t read_rubric_line(const Field& field, std::size_t lines)
{
    if (lines == 0 && field.given()) field.refuse("no line, since the unit has no rubric");
    return lines == 0 ? 0 : static_cast<std::size_t>(field.integer(1, static_cast<int>(lines)) - 1);
}

void expect_rubric_of_checks(const Field& field, const Exercise& exercise)
{
    for (std::size_t i = 0; i < exercise.rubric.size(); ++i) {
        Millipoints sum = 0;
        for (const Check& check : exercise.checks)
            if (check.rubric_line == i) sum += check.points;
        if (sum != exercise.rubric[i].points)
            field.refuse(fmt::format("points of line {} that are the sum of its checks' points, {}", i + 1,
                                     static_cast<double>(sum) / 1000));
    }
}

}
