#include <CLI/CLI.hpp>
#include <memory>

#include "calibrate/explanations.hpp"
#include "cli/application.hpp"

namespace umbral::grader {

void add_bench_explanations(CLI::App& bench, Application&)
{
    auto options = std::make_shared<ExplanationOptions>();
    CLI::App* command = bench.add_subcommand("explanations", "How often the right reason is given for a mistake, and a wrong one for other work");
    command->set_help_flag("-h,--help", "Print this help message and exit");
    command->add_option("--seeds", options->seeds, "How many sets of random inputs")->check(CLI::PositiveNumber)->capture_default_str();
    command->callback([options] { throw UsageError("umbral bench explanations measures nothing yet"); });
}

}
