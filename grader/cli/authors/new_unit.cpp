#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/authors/interface_block.hpp"
#include "cli/authors/unit_template.hpp"
#include "cli/paths.hpp"
#include "collect/sources.hpp"
#include "manifest/statements.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// A folder that the framework or the reference uses for something else is no topic, and its namespace neither.
void expect_topic(const fs::path& root, const std::string& topic)
{
    if (fs::is_directory(root / "exercises" / topic)) return;
    for (const fs::path& folder : {fs::path("framework/umbral") / topic, fs::path("reference") / topic})
        if (fs::exists(root / folder))
            throw UsageError(fmt::format(
                "'{}' cannot be a topic: {} is something else; expected a topic of exercises/, or a new name", topic,
                folder.string()));
}

/// Nothing of an author's is overwritten, and no unit is made half.
void expect_free(const fs::path& root, const std::vector<NewFile>& files, const UnitName& name)
{
    std::vector<std::string> taken;
    const fs::path folder = fs::path("exercises") / name.topic / name.unit;
    if (fs::exists(fs::symlink_status(root / folder))) taken.push_back(folder.string());
    for (const NewFile& file : files)
        if (!file.name.string().starts_with(folder.string() + "/") && fs::exists(fs::symlink_status(root / file.name)))
            taken.push_back(file.name.string());
    if (!taken.empty())
        throw UsageError(fmt::format(
            "{}/{} cannot be made, nothing was written; in the way: {}\nChoose another name, or move it away.",
            name.topic, name.unit, fmt::join(taken, ", ")));
}

void fill_interface_blocks(const fs::path& root, const UnitName& name)
{
    const Exercise exercise = load_exercise(root / "exercises" / name.topic / name.unit);
    for (const Language& language : languages) {
        const fs::path statement = exercise.folder / language.statement;
        write_output(statement,
                     with_interfaces(read_text(statement), language.interface, {exercise, root / "framework"}));
    }
}

void make_unit(const Application& application, const std::string& id)
{
    const Layout& layout = application.layout;
    if (layout.installed)
        throw UsageError(
            fmt::format("a unit is written into the sources of Umbral; this is an installation, without them, in {}. "
                        "Call ./umbral new-unit in "
                        "a checkout",
                        layout.data.string()));
    const UnitName name = read_unit_name(id);
    const fs::path& root = layout.data;
    const fs::path templates = root / "grader/cli/authors/templates";
    expect_topic(root, name.topic);
    const std::vector<NewFile> files = as_given([&] { return files_of_new_unit(templates / "unit", name); });
    expect_free(root, files, name);
    for (const NewFile& file : files) {
        make_folder((root / file.name).parent_path());
        write_output(root / file.name, file.text);
    }
    fill_interface_blocks(root, name);
    fmt::print("{}", filled_in(read_text(templates / "unit-next.txt.in"), name));
}

}

void add_new_unit(Command command, Application& application)
{
    auto id = std::make_shared<std::string>();
    command.option("TOPIC/NAME", *id, "What it is called; the topic may be new").required();
    command.runs([&application, id] { make_unit(application, *id); });
}

}
