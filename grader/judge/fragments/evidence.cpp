#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "judge/fragments/fragments.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_pixels_told = 16;
constexpr int most_side = 256;  // pixels of the picture
constexpr int margin = 2;       // pixels round the expected fragments, where extra ones are seen

// The colours of .fragments in evidence.css.
constexpr glm::u8vec4 matched_colour(150, 154, 160, 255);
constexpr glm::u8vec4 missing_colour(46, 126, 194, 255);
constexpr glm::u8vec4 extra_colour(224, 122, 36, 255);
constexpr glm::u8vec4 changed_colour(168, 72, 190, 255);

glm::u8vec4 colour_of(const FragmentTally& tally)
{
    return tally.wrong_value > 0                ? changed_colour
           : tally.missing > 0                  ? missing_colour
           : tally.extra + tally.duplicated > 0 ? extra_colour
                                                : matched_colour;
}

/// A picture of the pixels round the expected fragments; of several primitives at one pixel the wrong one shows.
struct Canvas {
    Image image;
    int x = 0;
    int y = 0;

    void paint(const Place& place, glm::u8vec4 colour)
    {
        const std::int64_t column = std::int64_t{place.x} - x;
        const std::int64_t row = std::int64_t{place.y} - y;
        if (column < 0 || row < 0 || column >= image.width || row >= image.height) return;
        glm::u8vec4& cell = image.at(static_cast<int>(column), static_cast<int>(row));
        if (cell.a == 0 || colour != matched_colour) cell = colour;
    }
};

Canvas canvas_for(Fragments expected)
{
    if (expected.empty()) return {};
    Place low = expected.front().place;
    Place high = low;
    for (const Fragment& fragment : expected) {
        low.x = std::min(low.x, fragment.place.x);
        low.y = std::min(low.y, fragment.place.y);
        high.x = std::max(high.x, fragment.place.x);
        high.y = std::max(high.y, fragment.place.y);
    }
    const auto side = [](std::int64_t from, std::int64_t to) {
        return static_cast<int>(std::min<std::int64_t>(to - from + 1 + 2 * margin, most_side));
    };
    return {Image(side(low.x, high.x), side(low.y, high.y), glm::u8vec4(0)), low.x - margin, low.y - margin};
}

std::vector<std::string> attribute_texts(const FragmentTable& table, Fragments here, int digits)
{
    if (here.empty()) return {"nothing"};
    std::vector<std::string> texts;
    for (const double value : table.attributes(here.front())) texts.push_back(number_text(value, digits));
    if (texts.empty()) texts.emplace_back("there");
    return texts;
}

RowPair row_of(const Place& place, const FragmentWords& words, const FragmentTable& yours, Fragments of_yours,
               const FragmentTable& expected, Fragments of_expected, const FragmentTally& tally)
{
    RowPair row;
    row.name = words.where(place);
    std::tie(row.yours, row.expected) = telling_apart([&](int digits) {
        return std::pair(attribute_texts(yours, of_yours, digits), attribute_texts(expected, of_expected, digits));
    });
    for (std::size_t i = 0; i < std::max(row.yours.size(), row.expected.size()); ++i)
        row.differs.push_back(row.yours.size() != row.expected.size() || row.yours[i] != row.expected[i]);
    row.note = tally.wrong_value > 0  ? "another value"
               : tally.missing > 0    ? "missing"
               : tally.duplicated > 0 ? fmt::format("{} times", of_yours.size())
                                      : "too many";
    return row;
}

}

Evidence fragments_evidence(const Check& check, const Observation& observation, bool right)
{
    if (right) return {};
    FragmentsEvidence evidence;
    evidence.sketch = observation.sketch;
    const Tensor& expected_tensor = *observation.expected;
    Tensor empty = expected_tensor;
    empty.rows = 0;
    empty.bytes.clear();
    const Tensor& yours_tensor = observation.yours->cells() == 0 ? empty : *observation.yours;
    if (expected_tensor.components < 3 || yours_tensor.components != expected_tensor.components) return {};
    const FragmentTable yours(yours_tensor);
    const FragmentTable expected(expected_tensor);
    const FragmentMatcher matcher(check, yours, expected);
    const FragmentWords words(text_of(observation.names));

    Canvas canvas = canvas_for(expected.sorted());
    for_each_place(
        yours.sorted(), expected.sorted(), [&](const Place& place, Fragments of_yours, Fragments of_expected) {
            const FragmentTally tally = matcher.at_place(of_yours, of_expected);
            evidence.right += tally.matched;
            evidence.missing += tally.missing;
            evidence.extra += tally.extra + tally.duplicated;
            evidence.changed += tally.wrong_value;
            if (words.are_pixels()) canvas.paint(place, colour_of(tally));
            if (!tally.all_right() && evidence.rows.first.size() < most_pixels_told)
                evidence.rows.first.push_back(row_of(place, words, yours, of_yours, expected, of_expected, tally));
        });
    evidence.rows.wrong = evidence.missing + evidence.extra + evidence.changed;
    evidence.x = canvas.x;
    evidence.y = canvas.y;
    if (words.are_pixels() && !canvas.image.cells.empty()) evidence.picture = canvas.image;
    return evidence;
}

}
