#include "batch/validate.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/application.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

struct Options {
    std::vector<std::string> units;
    unsigned seeds = 2;
    bool json = false;
    bool quiet = false;
};

void print(const Finding& finding, const Paint& paint)
{
    const std::string mark = finding.holds ? paint(Tone::good, paint.symbol("✓", "ok")) : paint(Tone::bad, paint.symbol("✗", "NO"));
    fmt::print("{} {:<24} {:<38} seed {}  {:6.1f} %  expected {:<16} {}\n", mark, finding.unit, finding.subject, finding.seed, finding.credit, finding.expected,
               paint.safe(finding.message));
    (void)std::fflush(stdout);
}

void validate(Application& application, const Options& options)
{
    Workshop workshop(application.tools);
    const Paint paint(application.style);
    std::size_t findings = 0;
    std::size_t failing = 0;
    nlohmann::json rows = nlohmann::json::array();
    for (const Exercise& exercise : application.chosen(options.units))
        validate_unit(workshop, exercise, options.seeds, [&](const Finding& finding) {
            ++findings;
            failing += finding.holds ? 0 : 1;
            if (options.json)
                rows.push_back({{"unit", finding.unit},
                                {"subject", finding.subject},
                                {"seed", finding.seed},
                                {"holds", finding.holds},
                                {"credit", finding.credit},
                                {"expected", finding.expected},
                                {"message", finding.message}});
            else if (!options.quiet || !finding.holds)
                print(finding, paint);
        });
    if (options.json)
        fmt::print("{}\n", nlohmann::json{{"format", "umbral-validation"}, {"version", 1}, {"findings", rows}}.dump(2, ' ', false,
                                                                                                                    nlohmann::json::error_handler_t::replace));
    else
        fmt::print("{} findings with {} seeds, {} of them not as they should be\n", findings, options.seeds, failing);
    if (failing != 0 || findings == 0) application.exit_status = exit_not_right;
}

}

void add_validate(CLI::App& parser, Application& application)
{
    auto options = std::make_shared<Options>();
    CLI::App* command = parser.add_subcommand("validate", "For authors and CI: proves that each unit's checks tell right from wrong");
    command->add_option("UNIT", options->units, "Only these units");
    command->add_option("--seeds", options->seeds, "How many sets of random inputs")->check(CLI::PositiveNumber)->capture_default_str();
    command->add_flag("--quiet", options->quiet, "Print only what fails");
    command->add_flag("--json", options->json, "As JSON");
    command->callback([&application, options] { validate(application, *options); });
}

}
