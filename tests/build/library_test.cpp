#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <set>
#include <sstream>

#include "build/inspection.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

std::string output_of(const std::string& command)
{
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "re"), &pclose);
    std::string text;
    std::array<char, 4096> part{};
    for (std::size_t got = 0; (got = std::fread(part.data(), 1, part.size(), pipe.get())) > 0;)
        text.append(part.data(), got);
    return text;
}

std::set<std::string> lines_of(const std::string& text)
{
    std::set<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.insert(line);
    return lines;
}

std::vector<fs::path> libraries_of_this_build()
{
    const fs::path build = UMBRAL_BUILD_DIR;
    std::vector<fs::path> libraries;
    for (const fs::path& root : {build / "lib", build / "units"})
        for (const auto& entry : fs::recursive_directory_iterator(root))
            if (entry.path().extension() == ".so") libraries.push_back(entry.path());
    return libraries;
}

// A unique symbol is one for the whole process, whatever the version script says.
TEST(Libraries, hold_no_unique_symbols)
{
    std::vector<fs::path> libraries = libraries_of_this_build();
    ASSERT_GE(libraries.size(), 7U);
    const Workbench bench;
    const Built built =
        bench.build_sphere(sphere_with("template <class T> struct Shared { static inline T value{}; };\ninline int& "
                                       "counter() { static int n = 0; return n; }\n",
                                       "    Shared<std::vector<int>>::value.push_back(++counter());"));
    ASSERT_EQ(to_string(built.verdict), "ok") << built.message;
    libraries.push_back(built.library);
    for (const fs::path& library : libraries) {
        const std::string symbols = output_of("readelf --syms --wide '" + library.string() + "'");
        EXPECT_NE(symbols.find("Symbol table"), std::string::npos) << library;
        EXPECT_EQ(symbols.find(" UNIQUE "), std::string::npos) << library;
    }
}

TEST(Libraries, the_framework_exports_no_data_that_can_be_written)
{
    const std::string symbols =
        output_of("nm --dynamic --defined-only '" UMBRAL_BUILD_DIR "/lib/libumbral-framework.so'");
    EXPECT_NE(symbols.find(" T _ZN6umbral8Recorder6append"), std::string::npos);
    std::istringstream lines(symbols);
    for (std::string address, kind, name; lines >> address >> kind >> name;) {
        EXPECT_EQ(std::string("BDGSuC").find(kind), std::string::npos) << kind << ' ' << name;
    }
}

TEST(Libraries, a_students_exports_exactly_the_unit)
{
    const Workbench bench;
    const Built built =
        bench.build_sphere(sphere_with("int helper = 3;\nint another() { return helper; }\nclass Open { public: "
                                       "virtual ~Open() = default; };\nOpen open_one;\n",
                                       "    helper += another();"));
    ASSERT_EQ(to_string(built.verdict), "ok") << built.message;
    const std::string symbols =
        output_of("nm --dynamic --defined-only --format=posix '" + built.library.string() + "' | cut -d' ' -f1");
    EXPECT_EQ(lines_of(symbols), lines_of(read_text(unit_folder(bench.tools(), "raytracing/sphere") / "exports.txt")));
}

TEST(Libraries, the_inspector_tells_places)
{
    const Workbench bench;
    const Built built = bench.build_sphere(sphere_with("", ""));
    ASSERT_EQ(to_string(built.verdict), "ok") << built.message;
    EXPECT_EQ(place_of(bench.tools(), built.library, {0, ~0ULL, 0xabababababababab}), "");
    const fs::path none = bench.write("none.so", "no library");
    EXPECT_FALSE(
        inspect(bench.tools(), none, unit_folder(bench.tools(), "raytracing/sphere") / "exports.txt").has_value());
}

// The compiler's own assembler is no word of the file's, so that nothing but what is assembled tells of it.
TEST(Libraries, are_made_of_no_assembler_whatever_let_it_in)
{
    const Workbench bench;
    const Built built = bench.build_sphere(
        "#include <immintrin.h>\n__attribute__((target(\"amx-tile\"))) void tiles() { _tile_release(); }\n" +
        sphere_with("", ""));
    EXPECT_EQ(to_string(built.verdict), "forbidden");
    EXPECT_NE(built.message.find("assembler is not allowed: "), std::string::npos) << built.message;
    EXPECT_EQ(built.message.find("umbral-as"), std::string::npos) << built.message;
}

/// Definitions that a student's file may hold, and that must mean nothing to anybody else.
class Overrides : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Overrides, change_nothing_outside)
{
    const Workbench bench;
    Worker worker(bench.tools());
    GradeOptions options;
    options.explain = false;
    const std::string text =
        std::string("#include <umbral/record/driver.hpp>\n#include <cstdlib>\n#include <cstring>\n#include <new>\n") +
        GetParam().second + project_file("reference/raytracing/sphere.cpp");
    const UnitResult result =
        grade_unit(worker, bench.exercise("raytracing/sphere"), {{{"sphere.cpp", text}}, {}, ""}, options);
    EXPECT_EQ(to_string(result.verdict), "ok") << result.message;
    EXPECT_EQ(result.score, 10000);
}

using NameAndCode = std::pair<const char*, const char*>;
INSTANTIATE_TEST_SUITE_P(
    All, Overrides,
    testing::Values(
        NameAndCode{"driver",
                    "const umbral::Driver umbral::driver = {{\"head-on\", [](Case&, Recorder& out) { out.append(\"t\", "
                    "1.0F); }}};\n"},
        NameAndCode{"malloc",
                    "extern \"C\" void* malloc(std::size_t) { std::abort(); }\nextern \"C\" void free(void*) { "
                    "std::abort(); }\n"},
        NameAndCode{
            "memcpy",
            "extern \"C\" [[gnu::used]] void* memmove(void* to, const void*, std::size_t) noexcept { return to; }\n"},
        NameAndCode{"recorder",
                    "void umbral::Recorder::append(std::string_view, std::optional<float>) {}\nvoid "
                    "umbral::Recorder::append(std::string_view, float) {}\n"},
        NameAndCode{"mark_not_implemented", "void umbral::mark_not_implemented() noexcept {}\n"},
        NameAndCode{"exit",
                    "extern \"C\" [[noreturn]] void _exit(int) { for (;;) {} }\nextern \"C\" [[gnu::used]] int "
                    "printf(const char*, ...) { return 0; }\n"},
        NameAndCode{"terminate", "namespace std { [[gnu::used]] void __throw_bad_alloc() { for (;;) {} } }\n"},
        NameAndCode{"write_tensors",
                    "#include <umbral/record/wire.hpp>\nstd::size_t umbral::wire::write_tensors(const "
                    "Recorder::Tensors&, std::span<std::byte>) { return 0; }\n"},
        NameAndCode{"square_root",
                    "extern \"C\" [[gnu::used]] double sin(double) noexcept { return 7; }\nextern \"C\" [[gnu::used]] "
                    "float cosf(float) noexcept { return 7; }\n"}),
    [](const auto& one) { return std::string(one.param.first); });

}
}
