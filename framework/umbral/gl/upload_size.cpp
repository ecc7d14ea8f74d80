#include <algorithm>
#include <umbral/gl/effects.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/pixel_size.hpp>
#include <umbral/gl/trace.hpp>

namespace umbral::gl {
namespace {

/// Products of sizes that a call claims stay far from overflow.
constexpr std::uint64_t largest = std::uint64_t{1} << 40U;

std::uint64_t product(std::uint64_t a, std::uint64_t b)
{
    return a == 0 || b == 0 ? 0 : a > largest / b ? largest : a * b;
}

unsigned digit(char c) { return c >= '1' && c <= '4' ? static_cast<unsigned>(c - '0') : 0; }

/// Bytes of one element of glUniform3fv, glProgramUniformMatrix2x4dv and the like.
unsigned uniform_size(std::string_view name)
{
    name.remove_prefix(name.find("Uniform") + std::string_view("Uniform").size());
    const bool matrix = name.starts_with("Matrix");
    if (matrix) name.remove_prefix(std::string_view("Matrix").size());
    const unsigned columns = name.empty() ? 0 : digit(name[0]);
    const bool oblong = matrix && name.size() > 2 && name[1] == 'x';
    const unsigned rows = oblong ? digit(name[2]) : matrix ? columns : 1;
    return columns * rows * (name.find("dv") != std::string_view::npos ? 8 : 4);
}

}

std::uint64_t upload_size(std::string_view name, const std::vector<double>& arguments)
{
    const FunctionRule* const rule = rule_of(name);
    if (rule == nullptr || (rule->effect != Effect::uploads && rule->effect != Effect::array)) return 0;
    const Size& size = rule->size;
    const auto number = [&](std::size_t i) { return i < arguments.size() ? whole(arguments[i]) : 0; };
    const auto type_at = [&](std::size_t i) {
        return static_cast<GLenum>(std::min<std::uint64_t>(number(i), 0xffffffffU));
    };
    const bool given = number(size.pointer) != 0;
    switch (size.kind) {
        case Size::Kind::none: return 0;
        case Size::Kind::bytes: return given ? number(size.first) : 0;
        case Size::Kind::picture: {
            if (!given) return 0;
            std::uint64_t pixels = 1;
            for (std::size_t i = 0; i < size.dimensions; ++i) pixels = product(pixels, number(size.first + i));
            return product(pixels, pixel_size(type_at(size.pointer - 2), type_at(size.pointer - 1)));
        }
        case Size::Kind::bits: return given ? product((number(size.first) + 7) / 8, number(size.first + 1)) : 0;
        case Size::Kind::items: {
            const std::uint64_t rows =
                size.dimensions == 0 ? 1 : number(size.dimensions);  // of a grid of control points
            return given ? product(product(number(size.first), rows), size.item) : 0;
        }
        case Size::Kind::fixed: return size.item;
        case Size::Kind::uniforms: return number(size.first) > 1 ? product(number(size.first), uniform_size(name)) : 0;
    }
    return 0;
}

}
