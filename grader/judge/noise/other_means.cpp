#include "judge/noise/other_means.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace umbral::grader {
namespace {

constexpr double most_chance = 1e-5;  ///< of one that is off: it is told beside one that surely is
constexpr std::size_t most_named = 4;

/// "the light of a slanted lamp by -25 %"
std::string in_words(int quantity, double change, double total, const std::vector<std::string>& names)
{
    const auto place = static_cast<std::size_t>(quantity);
    std::string name = place < names.size() ? names[place] : "";
    if (name.empty()) name = fmt::format("component {}", quantity);
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    if (total == 0) return name + ", which should be 0";
    return fmt::format("{} by {:+.3g} %", name, 100 * change / std::abs(total));
}

}

std::string others_in_words(const Estimates& yours, const Estimates& expected, int worst, const Forgiven& forgiven,
                            const std::vector<std::string>& names)
{
    if (expected.tiled || expected.channels < 2) return "";
    std::vector<std::string> off;
    for (int i = 0; i < expected.channels; ++i) {
        if (i == worst) continue;
        const TileSums sums = tilings_of(yours, expected, i).back().sums.back();
        if (tile_probability(sums, deviation_of(sums, forgiven)) < most_chance)
            off.push_back(in_words(i, sums.difference, sums.total, names));
    }
    const auto others = static_cast<std::size_t>(expected.channels - 1);
    if (off.empty()) return others == 1 ? " The other one is right." : fmt::format(" The {} others are right.", others);
    std::string text = others == 1            ? " The other one is off as well: "
                       : off.size() == others ? fmt::format(" All {} others are off as well: ", others)
                                              : fmt::format(" Of the {} others {} {} off as well: ", others, off.size(),
                                                            off.size() == 1 ? "is" : "are");
    for (std::size_t i = 0; i < std::min(off.size(), most_named); ++i) text += (i == 0 ? "" : ", ") + off[i];
    if (off.size() > most_named) text += fmt::format(" and {} more", off.size() - most_named);
    return text + ".";
}

}
