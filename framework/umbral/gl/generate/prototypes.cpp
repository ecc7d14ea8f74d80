#include "prototypes.hpp"

#include <array>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace umbral::gl::generate {
namespace {

constexpr std::array vendor_suffixes = {"ARB",   "EXT", "MESA",  "ATI", "NV",  "OES", "SGIS", "SGIX",
                                        "INTEL", "AMD", "APPLE", "KHR", "IBM", "HP",  "SUN",  "OVR"};

bool has_vendor_suffix(const std::string& name)
{
    for (const std::string suffix : vendor_suffixes)
        if (name.ends_with(suffix)) return true;
    return false;
}

Parameter parse_parameter(const std::string& text, const std::string& function)
{
    static const std::regex shape(R"(^\s*(.*?)(\w+)\s*(\[\d*\])?\s*$)");
    std::smatch match;
    if (!std::regex_match(text, match, shape) || match[1].str().empty())
        throw std::runtime_error("generate: expected a parameter like 'GLenum mode' in " + function + ", got '" + text +
                                 "'");
    return {match[1].str() + match[2].str() + match[3].str(), match[2].str()};
}

std::vector<Parameter> parse_parameters(const std::string& text, const std::string& function)
{
    static const std::regex nothing(R"(\s*(void)?\s*)");
    if (std::regex_match(text, nothing)) return {};
    std::vector<Parameter> parameters;
    std::istringstream list(text);
    for (std::string item; std::getline(list, item, ',');) parameters.push_back(parse_parameter(item, function));
    return parameters;
}

}

std::string without_comments(std::string_view text)
{
    std::string kept;
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "/*") {
            const std::size_t end = text.find("*/", i + 2);
            i = end == std::string_view::npos ? text.size() : end + 2;
        } else if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else {
            kept += text[i++];
        }
    }
    return kept;
}

std::string core_versions(std::string_view text, int major, int minor)
{
    static const std::regex opening(R"(^\s*#\s*ifndef\s+GL_VERSION_(\d)_(\d)\s*$)");
    static const std::regex conditional(R"(^\s*#\s*if.*)");
    static const std::regex closing(R"(^\s*#\s*endif.*)");
    std::istringstream lines{std::string(text)};
    std::string kept;
    int depth = 0;  // of conditionals inside a kept block
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (depth == 0) {
            if (!std::regex_match(line, match, opening)) continue;
            const int block_major = std::stoi(match[1]);
            if (block_major < major || (block_major == major && std::stoi(match[2]) <= minor)) depth = 1;
            continue;
        }
        if (std::regex_match(line, conditional)) ++depth;
        if (std::regex_match(line, closing)) --depth;
        kept += line + '\n';
    }
    return kept;
}

std::vector<Prototype> prototypes(const std::string& text)
{
    static const std::regex shape(R"(GLAPI\s+([\w\s\*]+?)\s*(?:GLAPIENTRY|APIENTRY)\s+(gl\w+)\s*\(([^()]*)\)\s*;)");
    static const std::regex spaces(R"(\s+)");
    std::vector<Prototype> found;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), shape); match != std::sregex_iterator(); ++match) {
        const std::string name = (*match)[2];
        if (has_vendor_suffix(name)) continue;
        const std::string parameters = std::regex_replace((*match)[3].str(), spaces, " ");
        found.push_back({(*match)[1], name, parse_parameters(parameters, name)});
    }
    return found;
}

}
