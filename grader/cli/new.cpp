#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "cli/framework_copy.hpp"
#include "cli/goal_pictures.hpp"
#include "cli/paths.hpp"
#include "manifest/statements.hpp"
#include "report/paint.hpp"
#include "store/sent_folder.hpp"
#include "unit/pictures.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct NewOptions {
    std::string folder;
    std::vector<std::string> units;
};

/// Copies a unit's stubs and statements; what is there already is a student's work and stays.
void make_unit(Worker& worker, const Exercise& exercise, const fs::path& root)
{
    const fs::path unit = exercise.id;
    as_given([&] {
        make_folder_below(root, unit);
        for (const std::string& file : exercise.files)
            if (!is_taken(root / unit / file)) copy_file_below(exercise.folder / file, root, unit / file);
        for (const auto& [code, statement, interface, hints] : languages)
            if (fs::exists(exercise.folder / statement))
                copy_file_below(exercise.folder / statement, root, unit / statement);
    });
    expect_writable(root / unit / "goal.png");
    (void)save_goal(worker, exercise, root / unit / "goal.png");
}

/// Who forgets the folder would get one that is called as the unit is, with all units in it.
void expect_folder(const Application& application, const NewOptions& options)
{
    std::error_code unknown;
    if (fs::exists(options.folder, unknown)) return;
    for (const Exercise& exercise : application.exercises)
        if (options.folder == exercise.id || options.folder == exercise.name)
            throw UsageError(
                fmt::format("expected a folder for the workspace before the units, got the unit '{0}'; for example: "
                            "umbral new work {0}",
                            options.folder));
}

void make_workspace(const Application& application, const NewOptions& options)
{
    expect_folder(application, options);
    const fs::path root = options.folder;
    const std::vector<Exercise> exercises =
        options.units.empty() ? application.readable() : application.chosen(options.units);
    make_folder(root);
    draw_goal_pictures(application, exercises,
                       [&](Worker& worker, std::size_t unit) { make_unit(worker, exercises[unit], root); });
    as_given([&] { copy_framework(application.tools, exercises, root); });
    const Paint paint(application.style);
    fmt::print(
        "Made {} with {} unit{}. Each has a README, the goal picture and a stub to fill in.\n"
        "Editors find the headers in include/ by compile_flags.txt; neither is handed in.\n\n",
        paint.safe(root.string()), exercises.size(), exercises.size() == 1 ? "" : "s");
    const Exercise& first = exercises.front();
    fmt::print("Begin with {}, then, in that folder:\n  umbral check {}\n",
               paint.safe((root / first.id / first.files.front()).string()), first.name);
}

}

void add_new(Command command, Application& application)
{
    auto options = std::make_shared<NewOptions>();
    command.option("DIR", options->folder, "Where").required();
    command.option("UNIT", options->units, "Only these units");
    command.runs([&application, options] { make_workspace(application, *options); });
}

}
