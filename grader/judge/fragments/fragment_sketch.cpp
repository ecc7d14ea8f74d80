#include <fmt/format.h>

#include "judge/fragments/fragments.hpp"

namespace umbral::grader {
namespace {

constexpr std::int32_t pixel_reach = 7;  // pixels to each side of the centre

struct Sign {
    char letter;
    const char* meaning;
};
constexpr Sign right_sign{'#', "right"};
constexpr Sign missing_sign{'-', "missing"};
constexpr Sign extra_sign{'+', "extra"};
constexpr Sign again_sign{'2', "drawn again"};
constexpr Sign wrong_sign{'~', "wrong value"};
constexpr Sign empty_sign{'.', "empty"};

const Sign& sign_of(const FragmentTally& tally)
{
    if (tally.duplicated > 0) return again_sign;
    if (tally.extra > 0) return extra_sign;
    if (tally.missing > 0) return missing_sign;
    return tally.wrong_value > 0 ? wrong_sign : right_sign;
}

struct PlaceWindow {
    Place low;
    Place high;
    [[nodiscard]] bool holds(const Place& place) const
    {
        return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
    }
};

// The pixels that either side has round the centre, cut to the reach.
PlaceWindow window_of(Fragments yours, Fragments expected, const Place& centre)
{
    const PlaceWindow reachable{{centre.primitive, centre.y - pixel_reach, centre.x - pixel_reach},
                                {centre.primitive, centre.y + pixel_reach, centre.x + pixel_reach}};
    PlaceWindow window{centre, centre};
    for (const Fragments list : {yours, expected})
        for (const Fragment& fragment : list) {
            if (!reachable.holds(fragment.place)) continue;
            window.low.x = std::min(window.low.x, fragment.place.x);
            window.low.y = std::min(window.low.y, fragment.place.y);
            window.high.x = std::max(window.high.x, fragment.place.x);
            window.high.y = std::max(window.high.y, fragment.place.y);
        }
    return window;
}

}

std::string fragment_sketch(const FragmentMatcher& matcher, const FragmentTable& yours, const FragmentTable& expected,
                            const Place& centre)
{
    const Fragments here = yours.of(centre.primitive);
    const Fragments there = expected.of(centre.primitive);
    const PlaceWindow window = window_of(here, there, centre);
    const auto width = static_cast<std::size_t>(window.high.x - window.low.x + 1);
    std::vector<std::string> rows(static_cast<std::size_t>(window.high.y - window.low.y + 1),
                                  std::string(width, empty_sign.letter));
    for_each_place(here, there, [&](const Place& place, Fragments a, Fragments b) {
        if (!window.holds(place)) return;
        rows[static_cast<std::size_t>(place.y - window.low.y)][static_cast<std::size_t>(place.x - window.low.x)] =
            sign_of(matcher.at_place(a, b)).letter;
    });
    std::string text;
    for (const std::string& row : rows) text += row + "\n";
    std::string legend = fmt::format("x {}..{}, y {}..{};", window.low.x, window.high.x, window.low.y, window.high.y);
    for (const Sign& sign : {right_sign, missing_sign, extra_sign, again_sign, wrong_sign, empty_sign})
        if (text.find(sign.letter) != std::string::npos) legend += fmt::format(" {} {}", sign.letter, sign.meaning);
    return text + legend;
}

}
