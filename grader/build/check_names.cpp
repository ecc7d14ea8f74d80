#include "build/check_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>

#include "build/allowed.hpp"
#include "build/demangle.hpp"

namespace umbral::grader {
namespace {

/// A signature as a student would write it: glm::vec3 for glm::vec<3, float, (glm::qualifier)0>, and so on.
std::string as_written(std::string signature)
{
    static const std::vector<std::pair<std::regex, std::string>> spellings = [] {
        std::vector<std::pair<std::regex, std::string>> list;
        for (const auto& [type, letter] :
             {std::pair("float", ""), std::pair("double", "d"), std::pair("int", "i"), std::pair("unsigned int", "u"), std::pair("bool", "b")}) {
            list.emplace_back(fmt::format(R"(glm::vec<(\d), {}, \(glm::qualifier\)0>)", type), fmt::format("glm::{}vec$1", letter));
            list.emplace_back(fmt::format(R"(glm::mat<(\d), \1, {}, \(glm::qualifier\)0>)", type), fmt::format("glm::{}mat$1", letter));
        }
        list.emplace_back(R"(std::__cxx11::basic_string<char, std::char_traits<char>, std::allocator<char> ?>)", "std::string");
        return list;
    }();
    for (const auto& [pattern, spelling] : spellings) signature = std::regex_replace(signature, pattern, spelling);
    return signature;
}

/// "umbral::raytracing::intersect" of "umbral::raytracing::intersect(umbral::Ray const&)".
std::string without_arguments(const std::string& signature) { return signature.substr(0, signature.find('(')); }

std::string last_part(const std::string& qualified)
{
    const std::size_t colon = qualified.rfind("::");
    return colon == std::string::npos ? qualified : qualified.substr(colon + 2);
}

/// Does a demangled function ("glm::mat<…> glm::lookAt<float>(…)") have this qualified name?
bool is_function(const std::string& demangled_name, const std::string& name)
{
    for (std::size_t at = demangled_name.find(name); at != std::string::npos; at = demangled_name.find(name, at + 1)) {
        const bool begins = at == 0 || demangled_name[at - 1] == ' ';
        const std::size_t end = at + name.size();
        if (begins && (end == demangled_name.size() || demangled_name[end] == '(' || demangled_name[end] == '<')) return true;
    }
    return false;
}

std::optional<Objection> missing_interface(const Inspection& inspection, const std::vector<std::string>& interface_names)
{
    for (const std::string& wanted : interface_names) {
        if (std::find(inspection.exported.begin(), inspection.exported.end(), wanted) != inspection.exported.end()) continue;
        const std::string declared = demangled(wanted.c_str());
        const std::string bare = last_part(without_arguments(declared));
        std::vector<std::string> written;
        for (const std::string& function : inspection.functions)
            if (function.find('(') != std::string::npos && last_part(without_arguments(function)) == bare) written.push_back(as_written(function));
        if (written.empty())
            return Objection{Verdict::interface_mismatch, fmt::format("your file does not define {}, which the header declares", as_written(declared))};
        return Objection{Verdict::interface_mismatch, fmt::format("you wrote {}, the header declares {}: make them equal, namespace and const included",
                                                                  fmt::join(written, " and "), as_written(declared))};
    }
    return std::nullopt;
}

}

std::optional<Objection> object_to(const Inspection& inspection, const std::vector<std::string>& interface_names, const std::set<std::string>& offered,
                                   const Exercise& exercise)
{
    // A forbidden name comes first: it is the reason to tell, even if the interface is wrong as well.
    for (const std::string& function : inspection.functions)
        for (const std::string& name : exercise.forbid)
            if (is_function(function, name))
                return Objection{Verdict::forbidden, fmt::format("{} is not allowed in this unit: it is what you are to write yourself", name)};
    if (auto missing = missing_interface(inspection, interface_names)) return missing;
    std::vector<std::string> wanted;
    for (const std::string& name : inspection.undefined)
        if (!is_allowed_symbol(name, exercise.gl, exercise.glfw) && !offered.contains(name)) wanted.push_back(demangled(name.c_str()));
    if (wanted.empty()) return std::nullopt;
    return Objection{Verdict::forbidden,
                     fmt::format("{}: no unit may call {}; allowed are the C++ library, mathematics, the framework and the units this one uses",
                                 fmt::join(wanted, ", "), wanted.size() == 1 ? "it" : "them")};
}

std::optional<Objection> object_to_words(const Sources& files, const Exercise& exercise)
{
    static const std::regex comments(R"(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/)");
    for (const auto& [file, text] : files) {
        std::string bare;
        std::regex_replace(std::back_inserter(bare), text.begin(), text.end(), comments, " ");
        for (const std::string& name : exercise.forbid)
            if (std::regex_search(bare, std::regex("\\b" + name + "\\b")))
                return Objection{Verdict::forbidden, fmt::format("{}: {} is not allowed in this unit", file, name)};
    }
    return std::nullopt;
}

}
