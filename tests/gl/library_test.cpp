#include <dlfcn.h>

#include <fstream>
#include <set>
#include <umbral/gl/opengl.hpp>

#include "elf.hpp"
#include "fixture.hpp"

namespace umbral::gl {
namespace {

const Exports& exports()
{
    static const Exports read = read_exports(UMBRAL_GL_LIBRARY);
    return read;
}

/// Functions that Khronos's core header (not one of those that the generator reads) declares up to OpenGL 4.5.
std::set<std::string> core_functions()
{
    std::ifstream header(UMBRAL_GL_HEADERS "/GL/glcorearb.h");
    std::set<std::string> names;
    for (std::string line; std::getline(header, line) && line.find("#ifndef GL_VERSION_4_6") == std::string::npos;) {
        const std::size_t start = line.find("APIENTRY gl");
        if (line.starts_with("GLAPI") && start != std::string::npos)
            names.insert(line.substr(start + 9, line.find(' ', start + 9) - start - 9));
    }
    return names;
}

TEST(Library, exports_every_core_function)
{
    const std::set<std::string> names = core_functions();
    ASSERT_GT(names.size(), 600U);
    const std::set<std::string> exported(exports().functions.begin(), exports().functions.end());
    for (const std::string& name : names) EXPECT_TRUE(exported.contains(name)) << name;
}

TEST(Library, exports_compatibility_functions)
{
    const std::set<std::string> exported(exports().functions.begin(), exports().functions.end());
    for (const char* name :
         {"glBegin", "glEnd", "glVertex4dv", "glLightfv", "glLightModeli", "glMaterialfv", "glColorMaterial",
          "glShadeModel", "glTexGenfv", "glFrustum", "glMultTransposeMatrixf", "glRenderMode", "glSelectBuffer",
          "glPushName", "glVertexPointer", "glCallList", "glWindowPos3fv", "glActiveTexture"})
        EXPECT_TRUE(exported.contains(name)) << name;
}

TEST(Library, holds_no_state_that_others_could_reach)
{
    for (const char* path : {UMBRAL_GL_LIBRARY, UMBRAL_FRAMEWORK_LIBRARY}) {
        EXPECT_EQ(read_exports(path).writable_data, std::vector<std::string>{}) << path;
        EXPECT_EQ(read_exports(path).unique, std::vector<std::string>{}) << path;
    }
}

TEST(Library, links_no_driver)
{
    for (const std::string& library : exports().needed)
        for (const char* driver : {"OSMesa", "libGL", "OpenGL", "EGL", "GLX"})
            EXPECT_EQ(library.find(driver), std::string::npos) << library;
}

using LoadedDriver = GlTest;

TEST_F(LoadedDriver, stays_private)
{
    // The driver exports functions of the same names: the process must only see ours.
    EXPECT_EQ(dlsym(RTLD_DEFAULT, "OSMesaCreateContext"), nullptr);
    Dl_info place{};
    ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, "glClear"), &place), 0);
    EXPECT_NE(std::string(place.dli_fname).find("libumbral-gl"), std::string::npos) << place.dli_fname;
}

TEST_F(LoadedDriver, answers_through_every_version)
{
    // One function of each version that gives something back: the driver answers unknown names too, so an address
    // proves nothing.
    GLuint names[8] = {};
    glGenTextures(1, names);
    glGenQueries(1, names + 1);
    glGenVertexArrays(1, names + 2);
    glGenSamplers(1, names + 3);
    glGenTransformFeedbacks(1, names + 4);
    glGenProgramPipelines(1, names + 5);
    glCreateBuffers(1, names + 6);
    names[7] = glCreateProgram();
    for (const GLuint name : names) EXPECT_NE(name, 0U);
}

}
}
