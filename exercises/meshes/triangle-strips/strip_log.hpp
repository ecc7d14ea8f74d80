#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <umbral/meshes/strips.hpp>
#include <umbral/record/recorder.hpp>
#include <utility>
#include <vector>

namespace umbral::meshes {

/// The same triangle, beginning with its smallest vertex.
inline glm::uvec3 turned(const glm::uvec3& t)
{
    if (t.y < t.x && t.y < t.z) return {t.y, t.z, t.x};
    if (t.z < t.x && t.z < t.y) return {t.z, t.x, t.y};
    return t;
}

/// What OpenGL would draw of these strips, as a sorted list: what two ways to cut a mesh into strips have in common.
/// Looks at no more indices than any sensible cut of a mesh of `triangle_count` triangles needs.
inline std::vector<glm::uvec3> drawn(const std::vector<Strip>& strips, std::size_t triangle_count)
{
    std::vector<glm::uvec3> triangles;
    std::size_t left = 8 * triangle_count + 100;
    for (const Strip& strip : strips) {
        std::size_t length = 0;  // of the strip so far
        for (std::size_t i = 0; i < strip.size() && left > 0; ++i, --left) {
            length = strip[i] == restart_index ? 0 : length + 1;
            if (length < 3) continue;
            const glm::uvec3 t(strip[length % 2 == 1 ? i - 2 : i - 1], strip[length % 2 == 1 ? i - 1 : i - 2],
                               strip[i]);
            if (t.x != t.y && t.y != t.z && t.z != t.x) triangles.push_back(turned(t));
        }
    }
    std::sort(triangles.begin(), triangles.end(), [](const glm::uvec3& a, const glm::uvec3& b) {
        return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    });
    return triangles;
}

/// Rows of a table that begin with the number of what they are about; its name stands in reports.
class StripLog {
public:
    StripLog(Recorder& out, std::string_view table) : out_(&out), table_(table) {}

    void begin(const std::string& name) { names_ += std::to_string(++count_) + " " + name + "\n"; }

    void add(std::initializer_list<std::uint32_t> numbers)
    {
        std::vector<float> row{static_cast<float>(count_)};
        for (const std::uint32_t number : numbers) row.push_back(static_cast<float>(number));
        out_->append(table_, row);
    }

    void add(const std::vector<glm::uvec3>& triangles)
    {
        for (const glm::uvec3& t : triangles) add({t.x, t.y, t.z});
    }

    void finish() const { out_->text(table_ + ".names", names_); }

private:
    Recorder* out_;
    std::string table_;
    std::string names_;
    int count_ = 0;
};

}
