#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <string_view>
#include <umbral/record/recorder.hpp>
#include <vector>

/// One way to write down what may be written in many: tables of a known length, lists of triangles and edges in no
/// particular order.
namespace umbral {

/// Records the first `count` rows of a table; rows that it lacks are recorded as not a number. Its size is another
/// observation.
template <class Row>
void record_rows(Recorder& out, std::string_view name, const std::vector<Row>& table, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        out.append(name, i < table.size() ? table[i] : Row(std::numeric_limits<float>::quiet_NaN()));
}

/// The same triangle, begun at its smallest index: its sense stays.
inline glm::uvec3 canonical(const glm::uvec3& t)
{
    if (t.y < t.x && t.y <= t.z) return {t.y, t.z, t.x};
    return t.z < t.x && t.z < t.y ? glm::uvec3(t.z, t.x, t.y) : t;
}

/// The same edge, begun at its smaller index: it has no sense.
inline glm::uvec2 canonical(const glm::uvec2& e) { return e.x <= e.y ? e : glm::uvec2(e.y, e.x); }

/// The same polygon, in the plane or in space, begun at another corner: whatever it begins with, it comes out the same.
/// Polygons may pass a place twice: what follows then decides.
template <int size>
std::vector<glm::vec<size, float>> from_extreme(std::vector<glm::vec<size, float>> polygon)
{
    const std::size_t count = polygon.size();
    const auto level = [&](std::size_t corner) {
        constexpr double weights[] = {0.83, 0.61, 0.47};
        double sum = 0;
        for (int i = 0; i < size; ++i) sum += weights[i] * double{polygon[corner % count][i]};
        return sum;
    };
    // Whether what is read from corner i comes first: it is larger in the first level in which they differ.
    const auto earlier = [&](std::size_t i, std::size_t j) {
        for (std::size_t k = 0; k < count; ++k) {
            const double difference = level(i + k) - level(j + k);
            if (std::abs(difference) > 1e-4) return difference > 0;
        }
        return false;
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i < count; ++i)
        if (earlier(i, first)) first = i;
    std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first), polygon.end());
    return polygon;
}

/// Records a list of triangles or edges as events of this code, each in its canonical form, sorted if their order is
/// free. Of a list that is far longer than it should be, only the beginning is looked at.
template <int size>
void record_indices(Recorder& out, std::string_view name, float code,
                    const std::vector<glm::vec<size, std::uint32_t>>& list, std::size_t expected_count,
                    bool any_order = true)
{
    const auto count = static_cast<std::ptrdiff_t>(std::min(list.size(), 2 * expected_count + 16));
    std::vector<glm::vec<size, std::uint32_t>> rows(list.begin(), list.begin() + count);
    for (auto& row : rows) row = canonical(row);
    const auto before = [](const auto& a, const auto& b) {
        for (int i = 0; i < size; ++i)
            if (a[i] != b[i]) return a[i] < b[i];
        return false;
    };
    if (any_order) std::sort(rows.begin(), rows.end(), before);
    for (const auto& row : rows) {
        std::array<float, size + 1> numbers{code};
        for (int i = 0; i < size; ++i) numbers[static_cast<std::size_t>(i) + 1] = static_cast<float>(row[i]);
        out.append(name, std::span<const float>(numbers));
    }
}

}
