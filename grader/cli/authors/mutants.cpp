#include "cli/authors/mutants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/authors/unit_pages.hpp"
#include "cli/checkout.hpp"
#include "cli/paths.hpp"
#include "mutants/mutants_table.hpp"
#include "mutants/unit_mutants.hpp"
#include "report/paint.hpp"

namespace umbral::grader {

void validate_mutants(Application& application, const MutantsOptions& options)
{
    const Paint paint(application.style);
    application.require_answers();
    expect_writable(options.markdown);
    const std::vector<Exercise> exercises =
        options.units.empty() ? application.readable() : application.chosen(options.units);
    const std::filesystem::path finder = have_finder(application, "validate --mutants finds mutants");
    have_built(application, exercises);
    Crew crew(application.tools, options.jobs);
    std::vector<UnitMutants> units;
    try_units(crew, options.family, finder, exercises, 0, [&](const UnitMutants& unit) {
        units.push_back(unit);
        if (options.json || (options.quiet && unit.holds())) return;
        fmt::print("{}", paint.safe_lines(mutants_text(unit)));
        (void)std::fflush(stdout);
    });
    if (options.json)
        fmt::print("{}\n", mutants_json(units).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    if (!options.markdown.empty())
        write_unit_page(application, options.markdown, mutants_markdown(options.family, units));
    const auto holding = std::ranges::count_if(units, &UnitMutants::holds);
    if (!options.json)
        fmt::print("{} units, {} of them with mutants that survive, or entries out of date\n", units.size(),
                   std::ssize(units) - holding);
    const bool all_read = !options.units.empty() || application.broken.empty();
    if (std::ssize(units) != holding || !all_read) application.exit_status = exit_not_right;
}

}
