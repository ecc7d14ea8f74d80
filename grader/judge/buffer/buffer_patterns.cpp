#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "judge/buffer/buffer_cells.hpp"
#include "judge/buffer/buffer_classes.hpp"

namespace umbral::grader {
namespace {

/// A rule is told only of at least so many values, and if this share of them follows it.
constexpr std::size_t least_cells = 8;
constexpr double most_of_them = 0.95;

struct CellPair {
    double yours;
    double expected;
};

// Component `index` of the cells with that state that hold finite values on both sides.
std::vector<CellPair> pairs_of(const BufferCells& cells, CellState state, std::size_t index)
{
    std::vector<CellPair> pairs;
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        if (cells.states[cell] != state || !cells.yours.present(cell) || !cells.expected.present(cell)) continue;
        const CellPair pair{cells.yours.cell(cell)[index], cells.expected.cell(cell)[index]};
        if (std::isfinite(pair.yours) && std::isfinite(pair.expected)) pairs.push_back(pair);
    }
    return pairs;
}

template <class Follows>
bool most(const std::vector<CellPair>& pairs, Follows follows)
{
    return static_cast<double>(std::ranges::count_if(pairs, follows)) >=
           most_of_them * static_cast<double>(pairs.size());
}

template <class Measure>
double median_of(const std::vector<CellPair>& pairs, Measure measure)
{
    std::vector<double> values;
    for (const CellPair& pair : pairs) values.push_back(measure(pair));
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double span_of(const std::vector<CellPair>& pairs)
{
    const auto [low, high] = std::ranges::minmax_element(pairs, {}, &CellPair::expected);
    return high->expected - low->expected;
}

// Is the value a whole number of steps, where a float could tell?
bool on_steps(double value, double step)
{
    constexpr double slack = 0.02;
    const double spacing = std::abs(value) * 6e-8 / step;
    const double at = value / step;
    return spacing < 0.1 && std::abs(at - std::round(at)) <= slack + spacing;
}

bool is_quantised(const std::vector<CellPair>& pairs, double step)
{
    return most(pairs,
                [step](const CellPair& pair) {
                    return on_steps(pair.yours, step) && std::abs(pair.yours - pair.expected) <= 1.02 * step;
                }) &&
           !most(pairs, [step](const CellPair& pair) { return on_steps(pair.expected, step); });
}

/// Do wrong values end where one side alone leaps, as they do where another surface was kept? Where one surface has
/// wrong values, both sides go on smoothly, or both end.
bool other_surfaces(const BufferCells& cells, double typical_error)
{
    const auto leaps = [&](const TensorView& side, std::size_t a, std::size_t b) {
        return std::abs(side.cell(a)[0] - side.cell(b)[0]) > 0.5 * typical_error;
    };
    std::size_t borders = 0;
    std::size_t of_one_side = 0;
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        if (cells.states[cell] != CellState::other) continue;
        for_each_near(cells, cell, [&](std::size_t near) {
            if (cells.states[near] != CellState::right) return;
            ++borders;
            if (leaps(cells.yours, cell, near) != leaps(cells.expected, cell, near)) ++of_one_side;
        });
    }
    return 2 * of_one_side > borders;
}

BufferPattern depth_pattern(const BufferCells& cells)
{
    const std::vector<CellPair> wrong = pairs_of(cells, CellState::other, 0);
    if (wrong.size() < least_cells) return {};
    const double span = span_of(wrong);
    const auto constant = [&](auto measure, double middle, double slack) {
        return most(wrong, [&](const CellPair& pair) { return std::abs(measure(pair) - middle) <= slack; });
    };
    const auto difference = [](const CellPair& pair) { return pair.yours - pair.expected; };
    const auto sum = [](const CellPair& pair) { return pair.yours + pair.expected; };
    const auto quotient = [](const CellPair& pair) { return pair.yours / pair.expected; };
    constexpr double slack = 0.02;

    for (const int bits : {8, 16, 24})
        if (is_quantised(wrong, 1 / (std::exp2(bits) - 1)))
            return {fmt::format("depths are rounded to {} bits", bits), {{"depth_bits", bits}}};
    const double offset = median_of(wrong, difference);
    if (constant(difference, offset, slack * std::abs(offset)))
        return {fmt::format("depths are all {} by {:.4g}", offset > 0 ? "too large" : "too small", std::abs(offset)),
                {{"depth_offset", offset}}};
    // One plane facing the viewer has one depth: nothing to tell a direction or a scale by.
    const bool spread = span > 1e-3 * std::abs(median_of(wrong, [](const CellPair& pair) { return pair.expected; }));
    if (const double middle = median_of(wrong, sum); spread && constant(sum, middle, slack * span))
        return {"depths run the other way: what is far is near", {{"depth_sum", middle}}};
    if (const double factor = median_of(wrong, quotient);
        spread && std::isfinite(factor) && constant(quotient, factor, slack * std::abs(factor - 1)))
        return {fmt::format("depths are all {:.4g} times the expected ones", factor), {{"depth_factor", factor}}};
    // Where all else is right, one direction means that another surface was kept.
    if (static_cast<double>(cells.count(CellState::right)) < 0.1 * static_cast<double>(wrong.size())) return {};
    if (!other_surfaces(cells, median_of(wrong, [&](const CellPair& pair) { return std::abs(difference(pair)); })))
        return {};
    if (most(wrong, [](const CellPair& pair) { return pair.yours > pair.expected; }))
        return {"the farther surface won: other depths are right", {{"farther", 1}}};
    if (most(wrong, [](const CellPair& pair) { return pair.yours < pair.expected; }))
        return {"a surface too near won: other depths are right", {{"nearer", 1}}};
    return {};
}

// Each expected id stands for one other id, and no two for the same.
BufferPattern renaming(const BufferCells& cells)
{
    constexpr std::size_t most_named = 4;
    std::map<double, std::map<double, std::size_t>> seen;
    std::size_t total = 0;
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        if (cells.states[cell] != CellState::right && cells.states[cell] != CellState::other) continue;
        if (!cells.yours.present(cell) || !cells.expected.present(cell)) continue;
        ++seen[cells.expected.cell(cell)[0]][cells.yours.cell(cell)[0]];
        ++total;
    }
    if (seen.size() < 2 || total < least_cells) return {};
    std::map<double, double> used;
    std::size_t followed = 0;
    std::size_t changed = 0;
    std::string list;
    for (const auto& [id, counts] : seen) {
        const auto usual = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
        followed += usual->second;
        if (!used.emplace(usual->first, id).second) return {};
        if (usual->first == id) continue;
        if (++changed <= most_named)
            list += fmt::format("{}{} for {}", list.empty() ? "" : ", ", number_text(usual->first), number_text(id));
    }
    if (changed == 0 || static_cast<double>(followed) < most_of_them * static_cast<double>(total)) return {};
    return {fmt::format("the shapes are right, but named otherwise: {}{}", list, changed > most_named ? ", ..." : ""),
            {{"renamed", static_cast<double>(changed)}}};
}

double degrees_between(std::span<const double> a, std::span<const double> b)
{
    const std::array<double, 3> cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return std::atan2(std::hypot(cross[0], cross[1], cross[2]), along) * 180 / std::numbers::pi;
}

BufferPattern normal_pattern(const BufferCells& cells)
{
    constexpr double no_angle = 0.05;
    std::vector<CellPair> angles;  // degrees; the length stands in `expected`
    for (std::size_t cell = 0; cell < cells.states.size(); ++cell) {
        if (cells.states[cell] != CellState::other || !cells.yours.present(cell) || !cells.expected.present(cell))
            continue;
        const auto yours = cells.yours.cell(cell);
        const double length = std::hypot(yours[0], yours[1], yours[2]);
        if (std::isfinite(length) && length > 0)
            angles.push_back({degrees_between(yours, cells.expected.cell(cell)), length});
    }
    if (angles.empty()) return {};
    double worst = 0;
    double sum = 0;
    for (const CellPair& angle : angles) worst = std::max(worst, angle.yours), sum += angle.yours;
    const double mean = sum / static_cast<double>(angles.size());
    const std::map<std::string, double> metrics{{"max_degrees", worst}, {"mean_degrees", mean}};
    if (most(angles, [](const CellPair& angle) { return angle.yours < no_angle; }))
        return {fmt::format("the directions are right, the lengths are not (about {})",
                            number_text(median_of(angles, [](const CellPair& a) { return a.expected; }))),
                metrics};
    if (most(angles, [](const CellPair& angle) { return angle.yours > 180 - no_angle; }))
        return {"normals point the other way", metrics};
    return {fmt::format("directions are up to {:.3g} degrees off, {:.3g} on average", worst, mean), metrics};
}

BufferPattern texture_pattern(const BufferCells& cells)
{
    std::array<double, 2> worst{};
    std::array<bool, 2> mirrored{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::vector<CellPair> wrong = pairs_of(cells, CellState::other, i);
        if (wrong.empty()) return {};
        for (const CellPair& pair : wrong) worst[i] = std::max(worst[i], std::abs(pair.yours - pair.expected));
        mirrored[i] = wrong.size() >= least_cells && worst[i] > 0 &&
                      most(wrong, [](const CellPair& pair) { return std::abs(pair.yours + pair.expected - 1) < 1e-3; });
    }
    const std::map<std::string, double> metrics{{"max_u_error", worst[0]}, {"max_v_error", worst[1]}};
    for (std::size_t i = 0; i < 2; ++i)
        if (mirrored[i] && worst[1 - i] < 1e-3)
            return {fmt::format("{} runs the other way (1 - {} is expected)", "uv"[i], "uv"[i]), metrics};
    return {fmt::format("off by up to {:.4g} in u, {:.4g} in v", worst[0], worst[1]), metrics};
}

}

BufferPattern find_pattern(const BufferCells& cells, BufferKind kind)
{
    switch (kind) {
        case BufferKind::ids: return renaming(cells);
        case BufferKind::depth: return depth_pattern(cells);
        case BufferKind::normals: return normal_pattern(cells);
        case BufferKind::texture: return texture_pattern(cells);
        case BufferKind::coverage:
        case BufferKind::cells: break;
    }
    return {};
}

}
