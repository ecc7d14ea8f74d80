#include <gtest/gtest.h>
#include <signal.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::test {
namespace {

const std::filesystem::path source = UMBRAL_SOURCE;

/// `umbral check --watch --json` in a folder; every line it prints is a report.
class Watching {
public:
    explicit Watching(const std::filesystem::path& folder)
        : pipe_(popen(("echo $$; exec " UMBRAL_PROGRAM " check sphere --watch --json --dir " + folder.string()).c_str(),
                      "re")),
          process_(std::stoi(line()))
    {
    }
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;
    ~Watching()
    {
        kill(process_, SIGINT);
        (void)pclose(pipe_);
    }

    /// The next report; waits for it.
    [[nodiscard]] nlohmann::json report() { return nlohmann::json::parse(line()); }

private:
    std::string line()
    {
        std::string text;
        for (int c = 0; (c = std::fgetc(pipe_)) != '\n' && c != EOF;) text += static_cast<char>(c);
        return text;
    }

    FILE* pipe_;
    pid_t process_;
};

std::string verdict_of(const nlohmann::json& report) { return report.at("submission").at("units").at(0).at("verdict"); }

TEST(Watch, checks_again_whatever_is_saved)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = "raytracing/sphere/sphere.cpp";
    folder.write(file, read(source / "tests/class/carla-typical-mistakes" / file));
    Watching watching(folder.path());
    EXPECT_EQ(verdict_of(watching.report()), "partial");

    // Saving in place.
    folder.write(file, "int broken(");
    EXPECT_EQ(verdict_of(watching.report()), "compile_error");

    // Saving by putting a new file over the old one, as many editors do; a file that is no part of a unit changes
    // nothing.
    folder.write("raytracing/sphere/notes.txt", "not checked");
    folder.write("raytracing/sphere/sphere.cpp~", read(source / "reference" / "raytracing/sphere.cpp"));
    std::filesystem::rename(folder / "raytracing/sphere/sphere.cpp~", folder / file);
    EXPECT_EQ(verdict_of(watching.report()), "ok");

    // Taken away, and put back into a new folder.
    std::filesystem::remove_all(folder / "raytracing");
    EXPECT_EQ(verdict_of(watching.report()), "missing");
    folder.write(file, read(source / "exercises" / file));
    EXPECT_EQ(verdict_of(watching.report()), "not_implemented");
}

}
}
