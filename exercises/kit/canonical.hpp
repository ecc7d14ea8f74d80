#pragma once

#include <algorithm>
#include <array>
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
