#pragma once

#include <array>
#include <string_view>

namespace umbral::grader {

/// Library functions whose calls are counted where work is: the linker puts the framework's `__wrap_…` in their place
/// (framework/umbral/record/counted_calls.cpp). cmake/UmbralUnit.cmake has the same list for the solutions that it
/// links.
inline constexpr std::array<std::string_view, 12> counted_calls{"memmove", "memcpy",  "memset", "memcmp",
                                                                "memchr",  "_Znwm",   "_Znam",  "_ZnwmRKSt9nothrow_t",
                                                                "_ZdlPv",  "_ZdlPvm", "_ZdaPv", "_ZdaPvm"};

}
