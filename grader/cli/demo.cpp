#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "cli/grading.hpp"

namespace umbral::grader {
namespace {

/// A folder that this user may write: an installation is somebody else's.
std::filesystem::path demo_secret(const Application& application)
{
    if (!application.layout.installed) return application.layout.build / "demo-secret";
    std::filesystem::create_directories(application.tools.cache);
    return application.tools.cache / "demo-secret";
}

/// The units that the demo shows, by their ids. Throws UsageError if the list is missing.
std::vector<std::string> demo_units(const std::filesystem::path& list)
{
    std::vector<std::string> units;
    std::ifstream stream(list);
    for (std::string line; std::getline(stream, line);)
        if (!line.empty() && line.front() != '#') units.push_back(line);
    if (units.empty())
        throw UsageError(fmt::format("{}: expected the units of the demo; it comes with the package umbral-instructor",
                                     list.string()));
    return units;
}

}

void add_demo(Command command, Application& application)
{
    auto out = std::make_shared<std::string>("out/demo");
    command.option("--out", *out, "Where reports go").with_default();
    command.runs([&application, out] {
        if (!std::filesystem::is_directory(application.layout.samples))
            throw UsageError(fmt::format("the sample class is not in {}; it comes with the package umbral-instructor",
                                         application.layout.samples.string()));
        GradeCommand grade;
        grade.submissions = application.layout.samples.string();
        grade.out = std::filesystem::absolute(*out).string();
        grade.units = demo_units(application.layout.samples.parent_path() / "demo-units.txt");
        grade.course = "demo";
        // A secret of its own: nothing of the user's is touched, and every machine sees the same demo.
        grade.secret_file = demo_secret(application).string();
        fmt::print(
            "Grading the sample class of ten: flawless, untouched, mistaken, different, broken, endless, crashing, "
            "greedy, half done and hostile.\n\n");
        (void)std::fflush(stdout);
        grade_and_print(application, grade);
    });
}

}
