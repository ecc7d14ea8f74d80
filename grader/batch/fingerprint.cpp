#include "batch/fingerprint.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>

namespace umbral::grader {
namespace {

std::string first_line_of(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::string processor()
{
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name") || line.starts_with("CPU part")) return line.substr(std::min(line.size(), line.find(':') + 2));
    return "unknown";
}

}

std::string version_of(const std::string& program)
{
    // The name comes from the build's own configuration, never from a submission.
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((program + " --version 2>/dev/null").c_str(), "re"), &pclose);
    std::array<char, 256> line{};
    if (!pipe || std::fgets(line.data(), line.size(), pipe.get()) == nullptr) return "";
    std::string text(line.data());
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

Fingerprint fingerprint(Workshop& workshop, const std::vector<Exercise>& exercises)
{
    Fingerprint result;
    result.version = first_line_of(workshop.tools().units.parent_path() / "version.txt");
    result.commit = first_line_of(workshop.tools().units.parent_path() / "commit.txt");
    result.cpu = processor();
    result.compiler = version_of(workshop.tools().compiler);
    result.libm = fmt::format("glibc {}", gnu_get_libc_version());
    const bool draws = std::any_of(exercises.begin(), exercises.end(), [](const Exercise& exercise) { return exercise.gl; });
    Spawner& spawner = workshop.spawner(draws);
    result.protections = spawner.protections();
    result.gl = draws ? spawner.gl() : "not used";
    return result;
}

}
