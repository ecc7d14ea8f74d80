#include "question/quantity.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace umbral::grader {
namespace {

constexpr std::array<std::string_view, 15> angles = {"angle",     "angles", "degrees", "radians", "azimuth",
                                                     "elevation", "fov",    "fovy",    "fovx",    "phi",
                                                     "theta",     "yaw",    "pitch",   "roll",    "turns"};
constexpr std::array<std::string_view, 6> directions = {"direction", "normal", "axis", "up", "tangent", "bitangent"};
constexpr std::array<std::string_view, 2> on_screen = {"width", "height"};
constexpr std::array<std::string_view, 3> depths = {"depth", "near", "far"};
constexpr std::array<std::string_view, 2> indices = {"index", "level"};
constexpr std::array<std::string_view, 7> lights = {"color",   "colors",   "emission", "ambient",
                                                    "diffuse", "specular", "albedo"};

bool is_of_a_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}

Quantity quantity_of(std::string_view name)
{
    name = name.substr(std::min(name.rfind('.') + 1, name.size()));
    Quantity quantity = Quantity::unknown;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t end = static_cast<std::size_t>(
            std::find_if_not(name.begin() + static_cast<std::ptrdiff_t>(at), name.end(), is_of_a_word) - name.begin());
        const std::string_view word = name.substr(at, end - at);
        if (std::ranges::find(angles, word) != angles.end()) return Quantity::angle;
        if (std::ranges::find(directions, word) != directions.end()) quantity = Quantity::direction;
        if (std::ranges::find(lights, word) != lights.end()) quantity = Quantity::light;
        if (std::ranges::find(on_screen, word) != on_screen.end()) quantity = Quantity::screen;
        if (std::ranges::find(depths, word) != depths.end()) quantity = Quantity::depth;
        if (std::ranges::find(indices, word) != indices.end()) quantity = Quantity::index;
        at = end + 1;
    }
    return quantity;
}

}
