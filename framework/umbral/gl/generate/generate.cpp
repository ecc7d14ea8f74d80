#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <umbral/gl/effects.hpp>

#include "prototypes.hpp"

// Writes the forwarders of libumbral-gl: one exported function for each entry point of OpenGL 1.0 to 4.5 (compatibility
// profile), with the table of names beside the table of addresses that the back end fills. Functions with a vendor's
// suffix are left out.
namespace umbral::gl::generate {
namespace {

std::string read(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error("generate: cannot read '" + path + "'");
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Functions of both headers, each once, in the headers' order.
std::vector<Prototype> all_functions(const std::string& gl, const std::string& glext)
{
    std::vector<Prototype> all;
    std::set<std::string> seen;
    for (const std::string& text : {without_comments(gl), core_versions(without_comments(glext), 4, 5)})
        for (const Prototype& function : prototypes(text))
            if (seen.insert(function.name).second) all.push_back(function);
    // The headers of OpenGL 4.5 hold over a thousand: fewer means that their layout changed and was not understood.
    if (all.size() < 1000)
        throw std::runtime_error("generate: expected at least 1000 functions in the headers, found " +
                                 std::to_string(all.size()));
    return all;
}

std::string forwarder(const Prototype& function, std::size_t slot)
{
    std::string declarations;
    std::string arguments;
    for (const Parameter& parameter : function.parameters) {
        declarations += (declarations.empty() ? "" : ", ") + parameter.declaration;
        arguments += ", " + parameter.name;
    }
    return function.result + " APIENTRY " + function.name + "(" + declarations + ") { return umbral::gl::forward" +
           (is_always_seen(function.name) ? "<true>(" : "(") + function.name + ", " + std::to_string(slot) + arguments +
           "); }\n";
}

void write(const std::string& path, const std::vector<Prototype>& functions)
{
    std::ofstream out(path);
    out << "// Generated from the installed OpenGL headers; do not edit.\n#include "
           "<umbral/gl/forward.hpp>\n\nnamespace umbral::gl {\n"
        << "const std::size_t entry_count = " << functions.size() << ";\nEntry entries[" << functions.size()
        << "];\nconst char* const entry_names[] = {\n";
    for (const Prototype& function : functions) out << "    \"" << function.name << "\",\n";
    out << "};\n}\n\nextern \"C\" {\n";
    for (std::size_t slot = 0; slot < functions.size(); ++slot) out << forwarder(functions[slot], slot);
    out << "}\n";
    out.close();
    if (!out) throw std::runtime_error("generate: cannot write '" + path + "'");
}

}
}

int main(int argc, char** argv)
{
    using namespace umbral::gl::generate;
    try {
        if (argc != 4) throw std::runtime_error("usage: umbral-gl-generate gl.h glext.h output.cpp");
        write(argv[3], all_functions(read(argv[1]), read(argv[2])));
        return 0;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
