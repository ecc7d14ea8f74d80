#include "build/allowed.hpp"

#include <algorithm>
#include <array>

#include "build/c_functions.hpp"
#include "build/system_libraries.hpp"

namespace umbral::grader {
namespace {

using Name = std::string_view;

/// Prefixes of the C++ library's mangled names: std::, its vtables, type information and guards.
constexpr Name prefixes[] = {"_ZSt",          "_ZNS",   "_ZNKS", "_ZNVS", "_ZNOS",  "_ZTVS",  "_ZTVNS",
                             "_ZTIS",         "_ZTINS", "_ZTSS", "_ZTTS", "_ZTTNS", "_ZGVNS", "_ZTVN10__cxxabiv1",
                             "_ZN9__gnu_cxx", "_ZTIN",  "_Zn",   "_Zd"};

/// Longer names are no function's of a system.
constexpr std::size_t longest = 512;

/// Type information of a fundamental type or a pointer to one, as `throw "text"` needs.
bool is_fundamental_type_information(Name name)
{
    if (!name.starts_with("_ZTI")) return false;
    name.remove_prefix(4);
    for (const Name prefix : {"P", "K"})
        if (name.starts_with(prefix)) name.remove_prefix(1);
    return name.size() == 1 && name.front() >= 'a' && name.front() <= 'z';
}

/// What the compiler calls for arithmetic that the processor lacks (complex products, integers of 128 bits, __float128,
/// whole powers): its names end in the kinds of numbers, and perhaps how many: `__muldc3`, `__fixtfti`.
bool is_arithmetic(Name name)
{
    if (!name.starts_with("__")) return false;
    while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.remove_suffix(1);
    constexpr std::array<Name, 13> kinds{"si", "di", "ti", "hf", "bf", "sf", "df", "xf", "tf", "sc", "dc", "xc", "tc"};
    return std::ranges::any_of(kinds, [&](Name kind) { return name.ends_with(kind); });
}

/// Mathematics of every kind that this machine has, the compiler's arithmetic, the C++ library and what throws and
/// catches for it.
bool is_of_the_language(Name name)
{
    if (name.size() > longest) return false;
    const std::string symbol(name);
    if (name.starts_with("_Z") || name.starts_with("__cxa_") || name == "__dynamic_cast" ||
        name == "__gxx_personality_v0" || name == "__once_proxy" || name.starts_with("__atomic_"))
        return defines(SystemLibrary::cpp, symbol);
    return defines(SystemLibrary::mathematics, symbol) ||
           (is_arithmetic(name) && defines(SystemLibrary::compiler, symbol));
}

}

bool is_allowed_symbol(std::string_view name, bool with_gl, bool with_glfw)
{
    if (std::any_of(std::begin(prefixes), std::end(prefixes), [&](Name prefix) { return name.starts_with(prefix); }))
        return true;
    if (is_fundamental_type_information(name)) return true;
    const auto has_prefix = [&](Name prefix) {
        return name.starts_with(prefix) && name.size() > prefix.size() && name[prefix.size()] >= 'A' &&
               name[prefix.size()] <= 'Z';
    };
    if (has_prefix("gl") || has_prefix("glX") || has_prefix("glfw")) {
        // Functions that find others by name would get around what the traces see.
        if (name.find("ProcAddress") != Name::npos || name.starts_with("glX")) return false;
        return (with_gl && has_prefix("gl")) || (with_glfw && has_prefix("glfw"));
    }
    if (const CFamily* family = c_family(name)) {
        if (family->allowed) return true;
        // Mathematics may share the look of a name with what is refused, as fegetenv does.
        return is_of_the_language(name);
    }
    return is_of_the_language(name);
}

std::string_view what_is_wrong_with(std::string_view name)
{
    const CFamily* const family = c_family(name);
    return family == nullptr || family->allowed ? "" : family->what;
}

}
