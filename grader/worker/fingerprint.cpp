#include "worker/fingerprint.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <algorithm>
#include <fstream>

#include "build/ask_program.hpp"

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
        if (line.starts_with("model name") || line.starts_with("CPU part"))
            return line.substr(std::min(line.size(), line.find(':') + 2));
    return "unknown";
}

}

std::string version_of(const std::string& program) { return ask_program(program, "--version"); }

Fingerprint fingerprint(Worker& worker, const std::vector<Exercise>& exercises)
{
    Fingerprint result;
    result.version = first_line_of(worker.tools().units.parent_path() / "version.txt");
    result.commit = first_line_of(worker.tools().units.parent_path() / "commit.txt");
    result.cpu = processor();
    result.compiler = version_of(worker.tools().compiler);
    result.libm = fmt::format("glibc {}", gnu_get_libc_version());
    const bool draws =
        std::any_of(exercises.begin(), exercises.end(), [](const Exercise& exercise) { return exercise.gl; });
    Spawner& spawner = worker.spawner(draws);
    result.protections = spawner.protections();
    result.gl = draws ? spawner.gl() : "not used";
    return result;
}

}
