#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "prototypes.hpp"

// Writes a weak function for each one that GLFW's header declares: it stops the case and names itself. Where
// libumbral-glfw defines the function, the linker takes that definition instead. So the library exports the header's
// functions exactly, whatever version is installed.
namespace {

std::string read(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error("generate: cannot read '" + path + "'");
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::string> functions_of(const std::string& header)
{
    static const std::regex declaration(R"(GLFWAPI\s[\w\s\*]*?(glfw\w+)\s*\()");
    std::vector<std::string> names;
    for (auto match = std::sregex_iterator(header.begin(), header.end(), declaration); match != std::sregex_iterator();
         ++match)
        names.push_back((*match)[1]);
    // GLFW 3.3 has 122: fewer means that the header's layout changed and was not understood.
    if (names.size() < 100)
        throw std::runtime_error("generate: expected at least 100 functions in GLFW's header, found " +
                                 std::to_string(names.size()));
    return names;
}

void write(const std::string& path, const std::vector<std::string>& names)
{
    std::ofstream out(path);
    out << "// Generated from the installed GLFW header; do not edit.\n// No call gets as far as its parameters, so "
           "none are declared.\n\n"
        << "namespace umbral::input::headless {\n[[noreturn]] void missing(const char* function);\n}\n\nextern \"C\" "
           "{\n";
    for (const std::string& name : names)
        out << "[[gnu::weak]] void " << name << "() { umbral::input::headless::missing(\"" << name << "\"); }\n";
    out << "}\n";
    out.close();
    if (!out) throw std::runtime_error("generate: cannot write '" + path + "'");
}

}

int main(int argc, char** argv)
{
    try {
        if (argc != 3) throw std::runtime_error("usage: umbral-glfw-generate glfw3.h output.cpp");
        write(argv[2], functions_of(umbral::gl::generate::without_comments(read(argv[1]))));
        return 0;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
