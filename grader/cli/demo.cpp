#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/application.hpp"
#include "cli/config.hpp"
#include "cli/grading.hpp"

namespace umbral::grader {

void add_demo(CLI::App& parser, Application& application)
{
    auto out = std::make_shared<std::string>("out/demo");
    CLI::App* command = parser.add_subcommand("demo", "Grades the sample class: ten submissions, from flawless to hostile");
    command->add_option("--out", *out, "Where reports go")->capture_default_str();
    command->callback([&application, out] {
        GradeCommand grade;
        grade.submissions = (std::filesystem::path(config::source_folder) / "tests" / "class").string();
        grade.out = std::filesystem::absolute(*out).string();
        grade.handed_in = true;
        grade.course = "demo";
        // A secret of its own: nothing of the user's is touched, and every machine sees the same demo.
        grade.secret_file = (std::filesystem::path(config::build_folder) / "demo-secret").string();
        fmt::print("Grading the sample class of ten: flawless, untouched, mistaken, different, broken, endless, crashing, greedy, half done and hostile.\n\n");
        (void)std::fflush(stdout);
        grade_and_print(application, grade);
    });
}

}
