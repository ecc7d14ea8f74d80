#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <sstream>

#include "build/submission.hpp"
#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "cli/paths.hpp"
#include "manifest/statements.hpp"
#include "report/paint.hpp"
#include "store/sent_folder.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// The numbered entries of a statement's section `heading`; an entry may go over several lines. Each may be folded:
/// lines that begin with a tag, such as <details>, belong to none.
std::vector<std::string> hints_in(const std::string& statement, const std::string& heading)
{
    std::vector<std::string> hints;
    std::istringstream text(statement);
    bool inside = false;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("## "))
            inside = line == heading;
        else if (line.starts_with('<'))
            continue;
        else if (inside && !line.empty() && line[0] >= '0' && line[0] <= '9')
            hints.push_back(line.substr(line.find_first_not_of("0123456789. ")));
        else if (inside && !line.empty() && !hints.empty())
            hints.back() += " " + line.substr(line.find_first_not_of(' '));
    }
    return hints;
}

void print_hint(const Application& application, const std::string& unit, std::size_t step, const Language& language)
{
    const Exercise exercise = application.chosen({unit}).front();
    const fs::path statement = exercise.folder / language.statement;
    const bool english = language.code == "en";
    if (!fs::exists(statement) && !english)
        throw UsageError(fmt::format("{0} has no statement in that language; in English: umbral hint {1} {2}",
                                     exercise.id, exercise.name, step));
    const std::vector<std::string> hints = hints_in(as_given([&] { return read_text(statement); }), language.hints);
    if (hints.empty()) throw UsageError(fmt::format("{} has no hints", exercise.id));
    if (step == 0 || step > hints.size())
        throw UsageError(
            fmt::format("{} has hints 1 to {}, each a step more; got {}", exercise.id, hints.size(), step));
    fmt::print("{} {} {} {}: {}\n", english ? "Hint" : "Pista", step, english ? "of" : "de", hints.size(),
               hints[step - 1]);
    if (step == hints.size()) return;
    if (english)
        fmt::print("\nOne step more: umbral hint {} {}\n", exercise.name, step + 1);
    else
        fmt::print("\nLa pista siguiente: umbral hint {} {} --language {}\n", exercise.name, step + 1, language.code);
}

/// The stub comes back; what was there is kept beside it, under a name that no check reads.
void reset_unit(const Application& application, const std::string& unit, const std::string& folder)
{
    const Exercise exercise = application.chosen({unit}).front();
    const fs::path root = folder;
    const fs::path place = root / exercise.id;
    const Paint paint(application.style);
    expect_folder(folder, "a workspace");
    make_folder_below(root, exercise.id);
    for (const std::string& file : exercise.files) {
        if (is_taken(place / file)) {
            int number = 1;
            while (is_taken(place / fmt::format("{}.{}.bak", file, number))) ++number;
            const fs::path kept = place / fmt::format("{}.{}.bak", file, number);
            fs::rename(place / file, kept);
            fmt::print("kept yours as {}\n", paint.safe(kept.string()));
        }
        copy_file_below(exercise.folder / file, root, fs::path(exercise.id) / file);
        fmt::print("put the stub back as {}\n", paint.safe((place / file).string()));
    }
}

}

void add_hint(Command command, Application& application)
{
    struct Options {
        std::string unit;
        std::size_t step = 1;
        std::string language = "en";
        std::string folder = ".";
    };
    auto options = std::make_shared<Options>();
    command.option("UNIT", options->unit, "Which unit").required();
    command.option("STEP", options->step, "Which hint").with_default();
    command.option("--dir", options->folder, "The workspace, as other commands take it: hints are the same in all");
    command.option("--language", options->language, "Of the hint").one_of({"en", "es"}).with_default();
    command.runs([&application, options] {
        print_hint(application, options->unit, options->step, language_of(options->language));
    });
}

void add_reset(Command command, Application& application)
{
    struct Options {
        std::string unit;
        std::string folder = ".";
    };
    auto options = std::make_shared<Options>();
    command.option("UNIT", options->unit, "Which unit").required();
    command.option("--dir", options->folder, "The workspace").with_default();
    command.runs([&application, options] {
        const std::string workspace = workspace_of({&options->unit, 1}, options->folder);
        as_given([&] { reset_unit(application, options->unit, workspace); });
    });
}

}
