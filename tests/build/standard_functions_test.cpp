#include <gtest/gtest.h>

#include <fstream>

#include "build/allowed.hpp"
#include "build/c_functions.hpp"
#include "build/system_libraries.hpp"
#include "standard_uses.hpp"
#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

std::string using_function(const std::string& code)
{
    const std::string headers =
        "#include <algorithm>\n#include <array>\n#include <bit>\n#include <cassert>\n#include <cctype>\n"
        "#include <cerrno>\n#include <cfenv>\n#include <charconv>\n#include <chrono>\n#include <cinttypes>\n"
        "#include <cmath>\n#include <complex>\n#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n"
        "#include <ctime>\n#include <cuchar>\n#include <cwchar>\n#include <cwctype>\n#include <functional>\n"
        "#include <limits>\n#include <map>\n#include <memory>\n#include <mutex>\n#include <numbers>\n"
        "#include <numeric>\n#include <optional>\n#include <random>\n#include <sstream>\n#include <string>\n"
        "#include <string_view>\n#include <valarray>\n#include <variant>\n#include <vector>\n";
    return sphere_with(headers +
                           "namespace {\nvolatile double sink = 0;\n"
                           "template <class T> void keep(T value) { sink = static_cast<double>(value); }\n}\n",
                       "volatile float number = ray.t_min;\n    const double x = number;\n    const int i = "
                       "static_cast<int>(number);\n    const std::string text = std::to_string(number);\n    "
                       "const std::wstring wide(text.begin(), text.end());\n    {\n" +
                           code + "\n    }\n");
}

class StandardFunctions : public testing::TestWithParam<Use> {};

TEST_P(StandardFunctions, are_allowed)
{
    const Workbench bench;
    const Built built = bench.build_sphere(using_function(GetParam().code));
    EXPECT_EQ(to_string(built.verdict), "ok") << built.message;
}

INSTANTIATE_TEST_SUITE_P(All, StandardFunctions, testing::ValuesIn(standard_uses),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(CFunctions, of_another_version_belong_with_those_of_this_one)
{
    for (const char* name : {"strtol", "__isoc23_strtol", "__isoc23_strtoull_l", "__strtol_internal", "__memcpy_chk",
                             "__isoc99_sscanf", "fputs_unlocked", "__isoc23_wcstoul", "__pthread_key_create"})
        EXPECT_TRUE(is_allowed_symbol(name, false, false)) << name;
    for (const char* name :
         {"__open64_2", "__isoc99_scanf", "__longjmp_chk", "__libc_system", "_Exit",   "fopen64",        "getenv",
          "mmap64",     "memfd_create",   "__sigaction",   "syscall",       "dlsym",   "pthread_create", "socket",
          "read",       "__read_chk",     "nanosleep",     "arc4random",    "environ", "setlocale"})
        EXPECT_FALSE(is_allowed_symbol(name, false, false)) << name;
    EXPECT_FALSE(is_allowed_symbol("no_such_function", true, true));
    EXPECT_EQ(what_is_wrong_with("fopen64"), "opens or changes files, or asks about them");
    EXPECT_EQ(what_is_wrong_with("no_such_function"), "");
}

// Decided name by name: what is in no family is refused, and so is what two could claim in another order.
TEST(CFunctions, that_do_what_a_unit_may_not_are_refused_by_whatever_name)
{
    for (const char* word : {"open",   "exec",   "fork",    "mmap",  "mprotect", "socket", "signal", "sigaction",
                             "dlopen", "dlsym",  "dlmopen", "clone", "ptrace",   "unlink", "rename", "getenv",
                             "setenv", "system", "popen",   "kill",  "longjmp",  "syscall"})
        for (const char* before : {"", "_", "__", "__libc_", "__isoc99_", "__isoc23_"})
            for (const char* after : {"", "64", "at", "at64", "_chk", "_l", "_2", "_internal", "v", "ve"}) {
                const std::string name = std::string(before) + word + after;
                EXPECT_FALSE(is_allowed_symbol(name, true, true)) << name;
            }
}

TEST(Mathematics, is_what_this_machines_library_has)
{
    for (const char* name : {"cabs", "cabsf", "carg", "cpow", "csqrtl", "fegetround", "sincosf", "llroundl", "nanf"})
        EXPECT_TRUE(defines(SystemLibrary::mathematics, name) && is_allowed_symbol(name, false, false)) << name;
    // Found through the library, but defined elsewhere.
    EXPECT_FALSE(defines(SystemLibrary::mathematics, "system"));
    EXPECT_FALSE(is_allowed_symbol("__register_frame", false, false));
    EXPECT_TRUE(is_allowed_symbol("__muldc3", false, false) && is_allowed_symbol("__divti3", false, false));
}

/// A sphere.cpp in which nothing calls `helper`.
Built with_unused(const Workbench& bench, const std::string& helper)
{
    return bench.build_sphere(
        sphere_with("#include <complex>\n#include <cstdio>\n#include <cstdlib>\n#include <unistd.h>\n" + helper, ""));
}

TEST(UnusedCode, is_not_held_against_the_file_that_it_stands_in)
{
    const Workbench bench;
    for (const char* helper :
         {"static void helper() { std::fopen(\"log\", \"w\"); }\n", "inline int helper() { return fork(); }\n",
          "void helper() { std::system(\"ls\"); }\n", "namespace { void helper() { _exit(1); } }\n",
          "struct Log { void helper() { (void)std::getenv(\"HOME\"); } };\nvoid another() { Log().helper(); }\n",
          "template <class T> T helper(T) { return T(getpid()); }\nint instance() { return helper(1); }\n"}) {
        const Built built = with_unused(bench, helper);
        EXPECT_EQ(to_string(built.verdict), "ok") << helper << built.message;
    }
}

TEST(UnusedCode, of_forbidden_functions_neither_unless_it_is_called)
{
    const Workbench bench;
    const std::string helper =
        "glm::mat4 other(glm::vec3 e, glm::vec3 t, glm::vec3 u) { return glm::lookAt(e, t, u); }\n";
    const auto view = [&](const std::string& answer) {
        return build(
            bench.tools(), bench.exercise("projections/view-matrix"),
            {{"view_matrix.cpp", helper +
                                     "namespace umbral::projections {\nglm::mat4 view_matrix(const glm::vec3& eye, "
                                     "const glm::vec3& target, const glm::vec3& up)\n{\n    return " +
                                     answer + ";\n}\n}\n"}});
    };
    EXPECT_EQ(to_string(view("glm::mat4(eye.x + target.x + up.x)").verdict), "ok");
    for (const char* answer : {"other(eye, target, up)", "glm::mat4(eye.x) * glm::lookAt(eye, target, up)",
                               "other(glm::vec3(0), glm::vec3(0, 0, -1), glm::vec3(0, 1, 0)) * eye.x"}) {
        const Built built = view(answer);
        EXPECT_EQ(to_string(built.verdict), "forbidden") << answer << built.message;
    }
}

TEST(UsedCode, is_refused_with_what_it_does)
{
    const Workbench bench;
    for (const char* helper : {"[[gnu::constructor]] void helper() { std::fopen(\"log\", \"w\"); }\n",
                               "static std::FILE* const helper = std::fopen(\"log\", \"w\");\n",
                               "struct Base { virtual void f() {} };\nstruct Log : Base { void f() override { "
                               "std::fopen(\"log\", \"w\"); } };\nLog log_one;\nBase* volatile base = &log_one;\n"
                               "const int once = (base->f(), 1);\n"}) {
        const Built built = with_unused(bench, helper);
        EXPECT_EQ(to_string(built.verdict), "forbidden") << helper << built.message;
        EXPECT_NE(built.message.find("fopen opens or changes files"), std::string::npos) << built.message;
    }
}

}
}
