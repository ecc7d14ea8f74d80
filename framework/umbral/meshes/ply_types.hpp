#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace umbral::meshes {

/// The types of numbers in PLY files, given to you.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The names of the types, the traditional ones first: the place modulo 8 is the type.
inline constexpr std::string_view ply_type_names[] = {"char",  "uchar",  "short",   "ushort", "int",   "uint",
                                                      "float", "double", "int8",    "uint8",  "int16", "uint16",
                                                      "int32", "uint32", "float32", "float64"};

/// The type of this name, if there is one.
[[nodiscard]] inline std::optional<PlyType> ply_type(std::string_view name)
{
    for (int i = 0; i < 16; ++i)
        if (ply_type_names[i] == name) return static_cast<PlyType>(i % 8);
    return std::nullopt;
}

/// Calls `use` with a zero of the C++ type: with_ply_type(PlyType::int16, use) is use(std::int16_t{}).
///
/// For example, `with_ply_type(type, [](auto zero) { return sizeof zero; })` is how many bytes a number of this type
/// takes.
template <class Use>
auto with_ply_type(PlyType type, Use use)
{
    switch (type) {
        case PlyType::int8: return use(std::int8_t{});
        case PlyType::uint8: return use(std::uint8_t{});
        case PlyType::int16: return use(std::int16_t{});
        case PlyType::uint16: return use(std::uint16_t{});
        case PlyType::int32: return use(std::int32_t{});
        case PlyType::uint32: return use(std::uint32_t{});
        case PlyType::float32: return use(float{});
        default: return use(double{});
    }
}

}
