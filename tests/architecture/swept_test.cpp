#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "sources.hpp"

namespace umbral::test {
namespace {

/// The declarations of a header, each on one line, without comments; "namespace umbral::meshes {" is one too.
std::vector<std::string> declarations_of(const std::filesystem::path& file)
{
    std::vector<std::string> all;
    std::string now;
    for (const Line& line : lines_of(file)) {
        const std::string text = line.text.substr(0, line.text.find("//"));
        if (text.find_first_not_of(' ') == std::string::npos || text.starts_with('#')) continue;
        now += (now.empty() ? "" : " ") + text.substr(text.find_first_not_of(' '));
        if (now.ends_with(';') || now.ends_with('{') || now.ends_with('}')) all.push_back(std::exchange(now, ""));
    }
    return all;
}

/// Functions of interfaces whose arguments are numbers, vectors and matrices in float, and whose answer holds such.
std::set<std::string> numeric_functions()
{
    static const std::regex opened(R"(namespace umbral::([\w:]+) \{)");
    const std::string argument = R"((?:const )?(?:float|glm::vec[234]|glm::mat[34])&? \w+(?:, )?)";
    const std::regex function(R"((?:\[\[nodiscard\]\] )?([\w:<>, ]+?) (\w+)\((?:)" + argument + R"()+\);)");
    static const std::regex other_answer("void|bool|std::(vector|unique_ptr|string).*|.*(u8|i|u|d)vec.*");
    std::set<std::string> names;
    for (const auto& file : files_below("framework/umbral")) {
        std::string scope;
        for (const std::string& declaration : declarations_of(file)) {
            std::smatch found;
            if (std::regex_match(declaration, found, opened)) scope = found[1];
            if (!scope.empty() && std::regex_match(declaration, found, function) &&
                !std::regex_match(found[1].str(), other_answer))
                names.insert(scope + "::" + found[2].str());
        }
    }
    return names;
}

/// What `umbral bench stability` asks, by the names of its calls.
std::set<std::string> swept_functions()
{
    static const std::regex call(R"re("((\w+::)+\w+)( \w+)?")re");
    std::set<std::string> names;
    for (const auto& file : files_below("reference/bench/stability/calls"))
        for (const Line& line : lines_of(file))
            for (std::sregex_iterator at(line.text.begin(), line.text.end(), call), end; at != end; ++at)
                names.insert((*at)[1]);
    return names;
}

// A function that gives NaN or infinity for finite numbers, where its header does not say so, would be seen nowhere
// else.
TEST(Swept, are_all_numeric_functions_of_interfaces)
{
    // Their files draw with OpenGL, which the bench does not have.
    const std::set<std::string> drawn = {"texturing::direction", "texturing::plane_along"};
    const std::set<std::string> swept = swept_functions();
    const std::set<std::string> functions = numeric_functions();
    EXPECT_GE(functions.size(), 70U) << "headers are not understood any more";
    for (const std::string& name : functions)
        EXPECT_TRUE(swept.contains(name) || drawn.contains(name))
            << name << " is not asked by the sweep of finite numbers: add it to reference/bench/stability/calls";
}

}
}
