#include <fmt/format.h>

#include "judge/fragments/fragments.hpp"

namespace umbral::grader {
namespace {

constexpr std::int32_t reach = 7;  // pixels to each side of the centre

struct Sign {
    char letter;
    const char* meaning;
};
constexpr Sign right{'#', "right"};
constexpr Sign missing{'-', "missing"};
constexpr Sign extra{'+', "extra"};
constexpr Sign again{'2', "drawn again"};
constexpr Sign wrong{'~', "wrong value"};
constexpr Sign empty{'.', "empty"};

const Sign& sign_of(const FragmentTally& tally)
{
    if (tally.duplicated > 0) return again;
    if (tally.extra > 0) return extra;
    if (tally.missing > 0) return missing;
    return tally.wrong_value > 0 ? wrong : right;
}

struct Window {
    Place low;
    Place high;
    [[nodiscard]] bool holds(const Place& place) const
    {
        return place.x >= low.x && place.x <= high.x && place.y >= low.y && place.y <= high.y;
    }
};

// The pixels that either side has round the centre, cut to the reach.
Window window_of(Fragments yours, Fragments expected, const Place& centre)
{
    const Window reachable{{centre.primitive, centre.y - reach, centre.x - reach},
                           {centre.primitive, centre.y + reach, centre.x + reach}};
    Window window{centre, centre};
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
    const Window window = window_of(here, there, centre);
    const auto width = static_cast<std::size_t>(window.high.x - window.low.x + 1);
    std::vector<std::string> rows(static_cast<std::size_t>(window.high.y - window.low.y + 1),
                                  std::string(width, empty.letter));
    for_each_place(here, there, [&](const Place& place, Fragments a, Fragments b) {
        if (!window.holds(place)) return;
        rows[static_cast<std::size_t>(place.y - window.low.y)][static_cast<std::size_t>(place.x - window.low.x)] =
            sign_of(matcher.at_place(a, b)).letter;
    });
    std::string text;
    for (const std::string& row : rows) text += row + "\n";
    std::string legend = fmt::format("x {}..{}, y {}..{};", window.low.x, window.high.x, window.low.y, window.high.y);
    for (const Sign& sign : {right, missing, extra, again, wrong, empty})
        if (text.find(sign.letter) != std::string::npos) legend += fmt::format(" {} {}", sign.letter, sign.meaning);
    return text + legend;
}

}
