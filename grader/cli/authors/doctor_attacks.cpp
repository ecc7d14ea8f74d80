#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "attack/rehearsal.hpp"
#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "model/caps.hpp"
#include "model/scratch.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

std::vector<attack::Attack> harmless_attacks(const fs::path& folder)
{
    if (!fs::is_directory(folder))
        throw UsageError(
            fmt::format("{}: there are no attacks; they come with Umbral's sources and the package umbral-instructor",
                        folder.string()));
    std::vector<attack::Attack> attacks = attack::load_attacks(folder);
    std::erase_if(attacks, [](const attack::Attack& one) { return !one.harmless; });
    return attacks;
}

/// Grades a class of the attacks of tests/attacks that do no harm even where they succeed, beside good work, in a
/// scratch folder on this machine; prints a line for each attack, what did not hold of it, and a sum. The exit status
/// says whether all held. Throws UsageError if the attacks are not there.
void attack_this_machine(Application& application)
{
    application.require_answers();
    const std::vector<attack::Attack> attacks = harmless_attacks(application.layout.attacks);
    const attack::Target target{application.tools.programs / "umbral", application.tools.reference,
                                application.tools.exercises, application.layout.samples, 0};
    attack::Setting setting;
    if (const char* const gl = std::getenv("UMBRAL_GL")) setting.gl = gl;

    fmt::print("{} attacks that do no harm are graded beside good work; this takes some minutes.\n", attacks.size());
    (void)std::fflush(stdout);
    const ScratchFolder scratch(fs::temp_directory_path());
    const attack::Rehearsal rehearsal = attack::rehearse(target, setting, attacks, scratch.path());
    const Paint paint(application.style);
    std::size_t held = 0;
    for (const attack::Attack& one : attacks) {
        const attack::Outcome& outcome = rehearsal.outcomes.at(one.id());
        const bool good = outcome.findings.empty();
        held += good ? 1 : 0;
        fmt::print(
            "{} {:<40} {}\n",
            good ? paint(Tone::good, paint.symbol("✓", "held")) : paint(Tone::bad, paint.symbol("✗", "NOT HELD")),
            one.theme + "/" + one.name, one_line(outcome.came));
        for (const std::string& finding : outcome.findings) fmt::print("    {}\n", one_line(finding, 400));
    }
    for (const std::string& change : rehearsal.changes_of_good)
        fmt::print("good work beside it changed: {}\n", one_line(change, 400));
    fmt::print(
        "\n{} of {} held; good work beside them {}. Grading took {:.0f} s, {:.0f} MiB of the grader's memory and "
        "{:.0f} MiB of disk.\n",
        held, attacks.size(),
        rehearsal.changes_of_good.empty() ? "kept its results to the byte" : "DID NOT KEEP ITS RESULTS",
        rehearsal.run.seconds, rehearsal.run.peak_mib, rehearsal.cache_mib + rehearsal.reports_mib);
    if (held < attacks.size() || !rehearsal.changes_of_good.empty()) application.exit_status = exit_not_right;
}

}

void add_doctor_attacks(Command command, Application& application)
{
    auto attack = std::make_shared<bool>(false);
    command.flag("--attack", *attack, "As `umbral doctor --attack`").required();
    command.runs([&application, attack] { attack_this_machine(application); });
}

}
