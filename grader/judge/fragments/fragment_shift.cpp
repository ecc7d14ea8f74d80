#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/explain/thresholds.hpp"
#include "judge/fragments/fragments.hpp"

namespace umbral::grader {
namespace {

/// Places that only one of both sides has.
struct Lonely {
    std::size_t missing = 0;
    std::size_t extra = 0;
    [[nodiscard]] std::size_t sum() const noexcept { return missing + extra; }
};

// A common step keeps the order of places, so both lists are still walked together.
Lonely lonely_places(Fragments yours, Fragments expected, PixelStep back)
{
    std::vector<Fragment> moved(yours.begin(), yours.end());
    for (Fragment& fragment : moved) {
        fragment.place.x -= back.dx;
        fragment.place.y -= back.dy;
    }
    Lonely lonely;
    for_each_place(moved, expected, [&](const Place&, Fragments here, Fragments there) {
        if (here.empty()) ++lonely.missing;
        if (there.empty()) ++lonely.extra;
    });
    return lonely;
}

std::string in_words(PixelStep step)
{
    const std::string across = step.dx > 0 ? "one pixel to the right" : step.dx < 0 ? "one pixel to the left" : "";
    const std::string down = step.dy > 0 ? "down" : step.dy < 0 ? "up" : "";
    if (across.empty()) return "one pixel too far " + down;
    return down.empty() ? across : across + " and one " + down;
}

}

std::vector<MovedPrimitive> moved_primitives(const FragmentTable& yours, const FragmentTable& expected)
{
    std::vector<MovedPrimitive> moved;
    for (Fragments rest = expected.sorted(); !rest.empty();) {
        const std::int32_t primitive = rest.front().place.primitive;
        const Fragments theirs = expected.of(primitive);
        rest = rest.subspan(theirs.size());
        const Fragments here = yours.of(primitive);
        // What is far larger or smaller is no moved copy; this also bounds the work by the size of what was expected.
        if (here.size() > 2 * theirs.size() + 2) continue;
        const Lonely before = lonely_places(here, theirs, {});
        if (before.missing == 0 || before.extra == 0) continue;
        MovedPrimitive best{primitive, {}, std::min(before.missing, before.extra)};
        std::size_t left = before.sum();
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (const std::size_t after = lonely_places(here, theirs, {dx, dy}).sum(); after < left)
                    left = after, best.step = {dx, dy};
        const bool explained =
            static_cast<double>(left) <= (1 - thresholds::explained) * static_cast<double>(before.sum());
        if (explained) moved.push_back(best);
    }
    return moved;
}

std::string moved_sentence(const std::vector<MovedPrimitive>& moved, const FragmentWords& words)
{
    const PixelStep step = moved.front().step;
    const auto others = static_cast<std::size_t>(std::ranges::count(moved, step, &MovedPrimitive::step)) - 1;
    const std::string more = others == 0 ? "" : fmt::format(" (and of {} other{})", others, others == 1 ? "" : "s");
    return fmt::format("all fragments of {} {}{} lie {}", words.primitive(), moved.front().primitive, more,
                       in_words(step));
}

}
