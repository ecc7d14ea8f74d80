#include "build/forbidden.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "build/header_texts.hpp"
#include "build/spelling.hpp"
#include "model/caps.hpp"
#include "model/forbidden_families.hpp"

namespace umbral::grader {
namespace {

bool matches_any(std::string_view text, const std::vector<std::string_view>& patterns)
{
    return std::ranges::any_of(patterns, [&](std::string_view pattern) { return matches_pattern(text, pattern); });
}

/// "glm/gtx/transform.inl" of "/usr/include/glm/gtx/transform.inl".
std::string below_include(const std::string& path)
{
    constexpr std::string_view folder = "/include/";
    const std::size_t at = path.rfind(folder);
    return at == std::string::npos ? path : path.substr(at + folder.size());
}

/// Does this function's name lie in GLM's headers?
bool is_of_glm(std::string_view header) { return header.starts_with("glm/"); }

/// What GLM's functions are made of where it uses the processor's vectors, "glm_vec4_dot", which it does only if it is
/// told to: where any of GLM's functions is forbidden, these are.
bool is_underneath(std::string_view header) { return header.starts_with("glm/simd/"); }

/// "glm::reflect" of "glm::detail::compute_reflect::call", which does its work; else the name itself.
std::string public_name(const std::string& name)
{
    constexpr std::string_view begin = "glm::detail::compute_";
    constexpr std::string_view end = "::call";
    if (!name.starts_with(begin) || !name.ends_with(end) || name.size() <= begin.size() + end.size()) return name;
    return "glm::" + name.substr(begin.size(), name.size() - begin.size() - end.size());
}

bool is_about_glm(std::string_view entry) { return entry.starts_with("glm::") || forbidden_family(entry) != nullptr; }

std::string sentence(std::string_view name, const ForbiddenFamily* family)
{
    if (family == nullptr)
        return fmt::format("{} is not allowed in this unit: it is what you are to write yourself", one_line(name));
    return fmt::format("{} is not allowed in this unit: what {} is what you are to write yourself", one_line(name),
                       family->what);
}

}

std::string qualified_name(std::string_view signature)
{
    std::string bare;
    int depth = 0;
    for (std::size_t i = 0; i < signature.size(); ++i) {
        const char c = signature[i];
        // "operator<" and its like open nothing.
        const bool of_operator = bare.ends_with("operator") || bare.ends_with("operator<") ||
                                 bare.ends_with("operator-") || bare.ends_with("operator>");
        if (depth == 0 && (c == '<' || c == '>') && of_operator)
            bare += c;
        else if (c == '<')
            ++depth;
        else if (c == '>')
            depth = std::max(0, depth - 1);
        else if (depth == 0 && c == '(' && !signature.substr(i).starts_with("(anonymous namespace)"))
            break;
        else if (depth == 0)
            bare += c;
    }
    while (bare.ends_with(' ')) bare.pop_back();
    // A template's signature begins with what it returns.
    const std::size_t unnamed = bare.rfind("(anonymous namespace)");
    const std::size_t space = bare.rfind(' ', unnamed == std::string::npos ? std::string::npos : unnamed);
    const bool is_operator = bare.find("operator ") != std::string::npos;
    return space == std::string::npos || is_operator ? bare : bare.substr(space + 1);
}

std::optional<std::string> find_forbidden(const Inspection& inspection, const std::vector<std::string>& forbid)
{
    if (forbid.empty()) return std::nullopt;
    HeaderTexts headers;
    std::optional<std::string> renamed;
    for (const InspectedFunction& function : inspection.functions) {
        const std::string header = below_include(function.file);
        const bool of_glm = is_of_glm(header);
        // A long type in what a function returns can leave nothing of its name, and a header can be read in a scope of
        // one's own: of GLM's functions the last name counts.
        const std::string bare = qualified_name(function.bare);
        std::string name = qualified_name(function.name);
        if (of_glm && (!name.starts_with("glm::") || last_name(name) != bare)) name = "glm::" + bare;
        for (const std::string& entry : forbid) {
            const ForbiddenFamily* family = forbidden_family(entry);
            if (family == nullptr && (matches_pattern(name, entry) || matches_pattern(public_name(name), entry) ||
                                      (of_glm && matches_pattern(bare, last_name(entry)))))
                return sentence(name, nullptr);
            if (family == nullptr || matches_any(name, family->except) || !matches_any(header, family->headers))
                continue;
            return sentence(name, family);
        }
        if (const auto about = std::ranges::find_if(forbid, is_about_glm);
            is_underneath(header) && about != forbid.end())
            return sentence(name, forbidden_family(*about));
        if (of_glm && !renamed && !headers.declares(function))
            renamed = fmt::format(
                "{} is a function of GLM's by another name ({}:{}): its headers are to be read as "
                "they are written",
                one_line(name), one_line(header), function.line);
    }
    for (const InspectedSymbol& symbol : inspection.undefined)
        for (const std::string& entry : forbid) {
            const ForbiddenFamily* family = forbidden_family(entry);
            if (family == nullptr ? matches_pattern(symbol.name, entry) : matches_any(symbol.name, family->symbols))
                return sentence(symbol.name, family);
        }
    return renamed;
}

}
