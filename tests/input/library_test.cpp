#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "../gl/elf.hpp"

namespace umbral::input {
namespace {

using Names = std::set<std::string>;

/// What a library exports under GLFW's prefix.
Names exported_by(const char* library)
{
    Names names;
    for (const std::string& name : gl::read_exports(library).functions)
        if (name.starts_with("glfw")) names.insert(name);
    return names;
}

std::string text_of(const char* path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What stands in the header, line by line: "GLFWAPI int glfwInit(void);".
Names declared()
{
    std::ifstream header(UMBRAL_GLFW_HEADER);
    Names names;
    for (std::string line; std::getline(header, line);) {
        const std::size_t start = line.find(" glfw") == std::string::npos ? line.find("*glfw") : line.find(" glfw");
        const std::size_t end = line.find('(');
        if (line.starts_with("GLFWAPI ") && start < end && end != std::string::npos)
            names.insert(line.substr(start + 1, end - start - 1));
    }
    return names;
}

TEST(HeadlessLibrary, exports_the_headers_functions_exactly)
{
    EXPECT_GT(declared().size(), 100U);
    EXPECT_EQ(exported_by(UMBRAL_GLFW_LIBRARY), declared());
}

#ifdef UMBRAL_REAL_GLFW
// But for functions of another header, about the window systems that GLFW knows.
TEST(HeadlessLibrary, exports_what_the_real_one_exports)
{
    Names theirs = exported_by(UMBRAL_REAL_GLFW);
    EXPECT_GT(theirs.size(), 100U);
    std::erase_if(theirs, [native = text_of(UMBRAL_GLFW_NATIVE_HEADER)](const std::string& name) {
        return native.find(name + "(") != std::string::npos;
    });
    EXPECT_EQ(exported_by(UMBRAL_GLFW_LIBRARY), theirs);
}
#endif

TEST(HeadlessLibrary, hides_its_state)
{
    const gl::Exports exports = gl::read_exports(UMBRAL_GLFW_LIBRARY);
    EXPECT_EQ(exports.writable_data, std::vector<std::string>{});
    EXPECT_EQ(exports.unique, std::vector<std::string>{});
    for (const std::string& name : exports.functions)
        EXPECT_TRUE(name.starts_with("glfw") || name.starts_with("_ZN6umbral5input8Headless") ||
                    name.starts_with("_ZNK6umbral5input8Headless"))
            << name;
    for (const std::string& library : exports.needed) EXPECT_EQ(library.find("libX"), std::string::npos) << library;
}

}
}
