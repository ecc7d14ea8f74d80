#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "build/compiler_files.hpp"
#include "installation.hpp"
#include "run/confine.hpp"

// The answers lie below the prefix, perhaps below /usr, which a compiler must read. What students' files ask for finds
// none of them.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

const fs::path right_answer = UMBRAL_SOURCE "/tests/class/ana-all-right/sphere.cpp";

/// An installation as students' files would look for it: at its own place, or mounted below /usr.
struct Place {
    fs::path prefix;
    std::string before;  ///< words before a command
};

std::vector<Place> places()
{
    const fs::path own = everything().prefix();
    std::vector<Place> all{{own, ""}};
    if (has_namespaces())
        all.push_back(
            {"/usr/local", "unshare -r -m sh -c 'mount --bind " + own.string() + " /usr/local && exec \"$@\"' sh "});
    return all;
}

/// Every installed file that students' code has no business with, as it is called below `prefix`.
std::vector<std::string> secrets(const fs::path& prefix)
{
    std::vector<std::string> names;
    const fs::path own = everything().prefix();
    for (const char* const folder :
         {"lib/umbral", "share/umbral/reference", "share/umbral/exercises", "share/umbral/class", "bin"}) {
        names.push_back((prefix / folder / "..").string() + "/" + fs::path(folder).filename().string() + "/nothing");
        for (const fs::path& file : files_below(own / folder)) {
            const std::string name = (prefix / fs::relative(file, own)).string();
            // The version script of the unit itself is the linker's to read.
            if (!name.ends_with("raytracing/sphere/exports.map") && name.find_first_of("\"\\") == std::string::npos)
                names.push_back(name);
        }
    }
    return names;
}

Printed check(const Place& place, const TemporaryFolder& folder, const std::string& probes,
              const std::string& options = "")
{
    folder.write("work/raytracing/sphere/sphere.cpp", probes + read(right_answer));
    return run(place.before + "env UMBRAL_CACHE=" + (folder / "cache").string() + " " +
               (place.prefix / "bin/umbral").string() + " check sphere --no-explanation " + options + " --dir " +
               (folder / "work").string());
}

TEST(Reach, has_include_finds_no_answer)
{
    // A student's file may hold half a mebibyte: so many questions fit.
    constexpr std::size_t most = 2000;
    for (const Place& place : places()) {
        const TemporaryFolder folder;
        const std::vector<std::string> names = secrets(place.prefix);
        ASSERT_GT(names.size(), 1000U);
        for (std::size_t first = 0; first < names.size(); first += most) {
            // Interfaces are there to be found: the question works.
            std::string probes = "#if !__has_include(<umbral/core/ray.hpp>)\n#error no interface\n#endif\n";
            for (const std::string& name : std::span(names).subspan(first, std::min(most, names.size() - first)))
                probes += "#if __has_include(\"" + name + "\")\n#error " + name + "\n#endif\n";
            for (const char* const name :
                 {"../reference/raytracing/sphere.cpp", "../exercises/raytracing/sphere/driver.cpp",
                  "umbral/../../reference/raytracing/sphere.cpp"})
                probes += std::string("#if __has_include(<") + name + ">)\n#error " + name + "\n#endif\n";
            const Printed checked = check(place, folder, probes);
            EXPECT_EQ(checked.status, 0) << place.prefix << checked.text;
        }
    }
}

TEST(Reach, include_finds_no_answer)
{
    for (const Place& place : places()) {
        const TemporaryFolder folder;
        for (const char* const name :
             {"share/umbral/reference/raytracing/sphere.cpp", "share/umbral/exercises/raytracing/sphere/driver.cpp",
              "lib/umbral/units/raytracing/sphere/exports.txt", "lib/umbral/version.txt", "bin/umbral"}) {
            const Printed checked =
                check(place, folder, "#include \"" + (place.prefix / name).string() + "\"\n", "--json");
            EXPECT_EQ(checked.status, 1) << name << checked.text;
            EXPECT_NE(checked.text.find("No such file"), std::string::npos) << name << checked.text;
        }
    }
}

// Assembler is refused before it is assembled; behind that, the assembler itself finds nothing either.
TEST(Reach, incbin_finds_no_answer)
{
    using namespace umbral::grader;
    const fs::path prefix = everything().prefix();
    const TemporaryFolder folder;
    const auto assemble = [&](const fs::path& file) {
        folder.write("probe.cpp", "asm(\".incbin \\\"" + file.string() + "\\\"\");\n");
        ConfinedCommand command;
        command.confine = prefix / "lib/umbral/bin/umbral-confine";
        command.directory = folder.path();
        command.read = compiler_files(UMBRAL_COMPILER);
        command.read.push_back((prefix / "share/umbral/framework").string());
        command.read.push_back((prefix / "lib/umbral/units/raytracing/sphere/exports.map").string());
        command.arguments = {UMBRAL_COMPILER, "-c", "probe.cpp"};
        return run_confined(command);
    };
    EXPECT_EQ(assemble(prefix / "share/umbral/framework/umbral/core/ray.hpp").exit_status, 0);
    for (const char* const name :
         {"share/umbral/reference/raytracing/sphere.cpp", "lib/umbral/units/raytracing/sphere/reference.so",
          "lib/umbral/units/raytracing/sphere/mistakes/far_root.veiled", "lib/umbral/units/lighting/shaders/shaders"}) {
        ASSERT_TRUE(fs::exists(prefix / name));
        const ConfinedResult result = assemble(prefix / name);
        EXPECT_NE(result.exit_status, 0) << name;
        EXPECT_NE(result.output.find("file not found"), std::string::npos) << result.output;
    }
}

}
}
