#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/authors/interface_block.hpp"
#include "cli/paths.hpp"
#include "collect/sources.hpp"
#include "manifest/exercise_schema.hpp"
#include "manifest/statements.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

struct RefreshOptions {
    std::vector<std::string> units;
    bool check = false;
};

/// Brings one statement up to date, or only says whether it is. Returns whether all is well with it.
bool refresh_statement(const Application& application, const Exercise& exercise, const Language& language, bool check)
{
    const fs::path file = exercise.folder / language.statement;
    const std::string shown = fmt::format("{}/{}", exercise.id, language.statement);
    if (!fs::exists(file)) {
        fmt::print("{}: missing; write it\n", shown);
        return false;
    }
    try {
        const std::string before = read_text(file);
        const std::string after = with_interfaces(before, language.interface, {exercise, application.tools.framework});
        if (after == before) return true;
        if (!check) write_output(file, after);
        fmt::print("{}: {}\n", shown, check ? "an interface block is not up to date" : "interface blocks written anew");
        return !check;
    } catch (const std::runtime_error& error) {
        fmt::print("{}: {}\n", shown, Paint(application.style).safe(error.what()));
        return false;
    }
}

/// The same for the schema of manifests, which lies in checkouts only.
bool refresh_schema(const Application& application, bool check)
{
    const fs::path file = application.layout.data / "docs/schemas/exercise.schema.json";
    if (!fs::exists(file)) return true;
    const std::string before = read_text(file);
    const std::string after = with_judges(nlohmann::ordered_json::parse(before)).dump(2) + "\n";
    if (after == before) return true;
    if (!check) write_output(file, after);
    fmt::print("docs/schemas/exercise.schema.json: {}\n",
               check ? "not up to date with the judges" : "written anew from the judges");
    return !check;
}

void refresh(Application& application, const RefreshOptions& options)
{
    const std::vector<Exercise> exercises =
        options.units.empty() ? application.readable() : application.chosen(options.units);
    bool all_well = true;
    for (const Exercise& exercise : exercises)
        for (const Language& language : languages)
            all_well = refresh_statement(application, exercise, language, options.check) && all_well;
    if (options.units.empty()) all_well = refresh_schema(application, options.check) && all_well;
    if (all_well) {
        fmt::print("The interface blocks of {} unit{} are up to date.\n", exercises.size(),
                   exercises.size() == 1 ? "" : "s");
        return;
    }
    if (options.check) fmt::print("\nTo write all this anew: umbral refresh\n");
    application.exit_status = exit_not_right;
}

}

void add_refresh(Command command, Application& application)
{
    auto options = std::make_shared<RefreshOptions>();
    command.option("UNIT", options->units, "Only these units");
    command.flag("--check", options->check, "Write nothing; say what is not up to date");
    command.runs([&application, options] { refresh(application, *options); });
}

}
