#include "scene/obj.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <umbral/meshes/polygons.hpp>

#include "scene/limits.hpp"
#include "text/printable.hpp"

namespace umbral::scene {
namespace {

constexpr std::string_view blanks = " \t";

[[noreturn]] void refuse(const std::string& where, const std::string& expected, std::string_view got)
{
    throw std::runtime_error(where + ": expected " + expected + ", got '" + printable(got, 60) + "'");
}

/// Takes the next word off a line; empty if there is none.
std::string_view take_word(std::string_view& line)
{
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

template <class Number>
bool is_number(std::string_view word)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size() && std::isfinite(static_cast<double>(number));
}

/// "7", "7/2", "7//3" or "7/2/3".
bool is_corner(std::string_view word)
{
    for (int part = 0; part < 3; ++part) {
        const std::string_view index = word.substr(0, word.find('/'));
        if ((part == 0 || !index.empty()) && !is_number<int>(index)) return false;
        if (index.size() == word.size()) return true;
        word.remove_prefix(index.size() + 1);
    }
    return false;
}

/// The library takes words that are no numbers for 0, without a word: here they are refused before it reads.
void refuse_what_are_no_numbers(std::string_view text)
{
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::string_view line = text.substr(0, text.find_first_of("\r\n"));
        text.remove_prefix(line.size());
        text.remove_prefix(std::min(text.size(), std::size_t{text.starts_with("\r\n") ? 2U : 1U}));
        const std::string_view keyword = take_word(line);
        const std::string where = "line " + std::to_string(number);
        const int least = keyword == "v" ? 3 : keyword == "vt" ? 1 : 0;
        for (int i = 0; i < least; ++i)
            if (const std::string_view word = take_word(line); !is_number<double>(word))
                refuse(where, "finite numbers after '" + std::string(keyword) + "'", word);
        if (keyword == "vt" && line.find_first_not_of(blanks) != std::string_view::npos)
            if (const std::string_view word = take_word(line); !is_number<double>(word))
                refuse(where, "finite numbers after 'vt'", word);
        if (keyword != "f") continue;
        for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
            if (!is_corner(word)) refuse(where, "corners of a face, as 7, 7/2, 7//3 or 7/2/3", word);
    }
}

/// What the library's calls add up to. Corners are kept as places in the lists, from 0.
class Obj {
public:
    static tinyobj::callback_t calls()
    {
        tinyobj::callback_t calls;
        calls.vertex_cb = [](void* obj, float x, float y, float z, float) {
            static_cast<Obj*>(obj)->add_position({x, y, z});
        };
        calls.texcoord_cb = [](void* obj, float u, float v, float) { static_cast<Obj*>(obj)->add_uv({u, v}); };
        calls.index_cb = [](void* obj, tinyobj::index_t* corners, int count) {
            static_cast<Obj*>(obj)->add_face({corners, static_cast<std::size_t>(count)});
        };
        return calls;
    }

    [[nodiscard]] Triangles triangles()
    {
        for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
            require_in_range(face, mesh_.faces[face], mesh_.positions.size(), "positions");
            require_in_range(face, uvs_.faces[face], uvs_of_corners_.size(), "texture coordinates");
        }
        meshes::IndexedMesh mesh = meshes::fan_triangles(mesh_);
        Triangles result{std::move(mesh.positions), std::move(mesh.triangles), {}, {}};
        if (!has_uvs_) return result;
        result.uvs = std::move(uvs_of_corners_);
        result.uv_triangles = meshes::fan_triangles(uvs_).triangles;
        const auto without = static_cast<std::uint32_t>(result.uvs.size());
        result.uvs.emplace_back(0);
        for (glm::uvec3& triangle : result.uv_triangles)
            for (int i = 0; i < 3; ++i) triangle[i] = std::min(triangle[i], without);
        return result;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    static void require_room(std::size_t count, const char* what)
    {
        if (count > maximum_vertices)
            throw std::runtime_error("expected at most " + std::to_string(maximum_vertices) + " " + what +
                                     ", got more");
    }

    void add_position(const glm::vec3& position)
    {
        mesh_.positions.push_back(position);
        require_room(mesh_.positions.size(), "positions");
    }

    void add_uv(const glm::vec2& uv)
    {
        uvs_of_corners_.push_back(uv);
        require_room(uvs_of_corners_.size(), "texture coordinates");
    }

    void add_face(std::span<const tinyobj::index_t> corners)
    {
        std::vector<std::uint32_t>& face = mesh_.faces.emplace_back();
        std::vector<std::uint32_t>& uv_face = uvs_.faces.emplace_back();
        for (const tinyobj::index_t& corner : corners) {
            face.push_back(place(corner.vertex_index, mesh_.positions.size(), "positions"));
            uv_face.push_back(corner.texcoord_index == 0
                                  ? none
                                  : place(corner.texcoord_index, uvs_of_corners_.size(), "texture coordinates"));
            has_uvs_ = has_uvs_ || uv_face.back() != none;
        }
        triangle_count_ += corners.size() < 3 ? 0 : corners.size() - 2;
        require_room(triangle_count_, "triangles");
        require_room(mesh_.faces.size(), "faces");
    }

    /// Of an index as it stands in the file: from 1, or from the last one backwards.
    [[nodiscard]] std::uint32_t place(int index, std::size_t so_far, const char* what) const
    {
        const std::int64_t from_zero = index > 0 ? std::int64_t{index} - 1 : std::int64_t(so_far) + index;
        if (index == 0 || from_zero < 0)
            refuse("face " + std::to_string(mesh_.faces.size()),
                   "indices from 1 on, or from -1 to minus the number of " + std::string(what) + " so far, " +
                       std::to_string(so_far),
                   std::to_string(index));
        return static_cast<std::uint32_t>(from_zero);
    }

    static void require_in_range(std::size_t face, std::span<const std::uint32_t> places, std::size_t count,
                                 const char* what)
    {
        for (const std::uint32_t one : places)
            if (one != none && one >= count)
                refuse("face " + std::to_string(face + 1),
                       "indices of at most " + std::to_string(count) + ", the number of " + what,
                       std::to_string(std::uint64_t{one} + 1));
    }

    meshes::PolygonMesh mesh_;
    meshes::PolygonMesh uvs_;  ///< faces only, as many and as long as mesh_ has
    std::vector<glm::vec2> uvs_of_corners_;
    std::size_t triangle_count_ = 0;
    bool has_uvs_ = false;
};

}

Triangles read_obj(const std::string& text)
{
    refuse_what_are_no_numbers(text);
    std::istringstream stream(text);
    Obj obj;
    std::string trouble;
    if (!tinyobj::LoadObjWithCallback(stream, Obj::calls(), &obj, nullptr, nullptr, &trouble))
        throw std::runtime_error("expected an OBJ file, got what is none: " + printable(trouble, 200));
    return obj.triangles();
}

}
