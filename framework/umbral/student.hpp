#pragma once

// What every student's file sees before its first line, precompiled. The headers that the unit's stub includes follow
// it, so that a macro of the student's cannot change the layout of anything the driver shares with it. What several
// interfaces include stands here, since it is then read once for all.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/random.hpp>
#include <umbral/core/ray.hpp>
#include <utility>
#include <variant>
#include <vector>

namespace umbral::detail {

/// Does with a string of this character type what the functions of <string> that are no templates do with one. What a
/// constant expression calls is instantiated at once, and so lies in the precompiled header; g++ leaves all else that
/// they call to be instantiated in each file once more, which takes a sixth of the time of compiling a short one.
template <class Character>
consteval bool has_instantiated_strings()
{
    using String = std::basic_string<Character>;
    constexpr std::array letters{Character{'a'}, Character{0}};
    String made(letters.data(), 1);
    String moved(std::move(made));
    made = moved;
    made += String(3, letters[0]);
    made.resize(made.capacity() + 1);
    return made.substr(1) != String(letters.data());
}

#if __cpp_lib_constexpr_string >= 201907L && !defined(__clang__)
static_assert(has_instantiated_strings<char>() && has_instantiated_strings<wchar_t>() &&
              has_instantiated_strings<char8_t>() && has_instantiated_strings<char16_t>() &&
              has_instantiated_strings<char32_t>());
#endif

}
