#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "inputs.hpp"
#include "page.hpp"

// umbral-bench-stability: started by `umbral bench`, since the grader knows no reference.
namespace {

using namespace stability;

struct Options {
    std::uint32_t questions = 20000;
    std::uint64_t seed = 1;
    std::string html;
    bool quick = false;
    bool verdicts = false;
};

int print_table(const std::vector<Result>& results)
{
    fmt::print("{:42} {:>10} {:>10} {:>10} {:>10} {:>8} {:18} {:>6}\n", "function", "naive med", "naive max", "ref med",
               "ref max", "bound", "unit", "used");
    int failures = 0;
    for (const Result& one : results) {
        const bool naive = one.row.naive != nullptr;
        fmt::print("{:42} {:>10} {:>10} {:>10.3g} {:>10.3g} {:>8.3g} {:18} {:>5.0f}%{}\n", one.row.name,
                   naive ? fmt::format("{:.3g}", one.naive.median) : "-",
                   naive ? fmt::format("{:.3g}", one.naive.worst) : "-", one.reference.median, one.reference.worst,
                   one.row.bound, unit_text(one.row.unit), 100 * one.used, failed(one) ? "  FAILED" : "");
        if (!failed(one)) continue;
        ++failures;
        fmt::print("    {}\n", one.asked == 0 ? "no question had an answer" : code_of(one.call, one.worst));
    }
    return failures;
}

int print_sweeps(const std::vector<SweepResult>& sweeps)
{
    int failures = 0;
    fmt::print("\n{:36} {:36} {:>9} {:>7}\n", "function", "relation", "worst ulp", "allowed");
    for (const SweepResult& one : sweeps) {
        failures += failed(one) ? 1 : 0;
        fmt::print("{:36} {:36} {:>9.3g} {:>7}{}\n", one.relation.function, one.relation.holds, one.worst,
                   one.relation.ulps, failed(one) ? "  FAILED" : "");
    }
    return failures;
}

int print_finite(const FiniteResult& finite)
{
    fmt::print(
        "\n{} functions, {} extreme questions of finite numbers that their headers allow: {} refused by an exception, "
        "{} whose right answer "
        "exceeds every float; NaN or infinity otherwise from {} functions\n",
        finite.functions, finite.asked, finite.refused, finite.overflowed, finite.escapes.size());
    for (const Escape& one : finite.escapes) fmt::print("    FAILED {}: {}\n", one.function, one.code);
    return static_cast<int>(finite.escapes.size());
}

void write_page(const Options& options, const Measured& measured)
{
    std::ofstream stream(options.html, std::ios::binary);
    stream << page_of(measured);
    if (!stream.flush())
        throw std::runtime_error("cannot write " + options.html +
                                 ": is the disk full, or the folder not yours? --html FILE chooses another");
    fmt::print("\n{}\n", options.html);
}

// One line a function: all that must be the same whatever compiled the references.
int print_verdicts(const std::vector<Result>& results)
{
    for (const Result& one : results) fmt::print("{} {}\n", failed(one) ? "FAILED" : "ok", one.row.name);
    return static_cast<int>(std::ranges::count_if(results, [](const Result& one) { return failed(one); }));
}

int run(const Options& options)
{
    const std::uint32_t count = options.quick ? 2000 : options.questions;
    Measured all{measured(count, options.seed), {}, {}, count, options.seed};
    if (options.verdicts) return print_verdicts(all.results) == 0 ? 0 : 1;
    all.sweeps = swept(count, options.seed);
    all.finite = finite_sweep(count, options.seed);
    const int failures = print_table(all.results) + print_sweeps(all.sweeps) + print_finite(all.finite);
    fmt::print("\n{} functions, {} questions each, seed {}: {}\n", all.results.size(), count, options.seed,
               failures == 0 ? "all within their bounds" : fmt::format("{} failures", failures));
    fmt::print("the textbook's formula breaks the bound in {} of {} functions\n",
               std::ranges::count_if(all.results, [](const Result& one) { return one.naive_exceeds; }),
               std::ranges::count_if(all.results, [](const Result& one) { return one.row.naive != nullptr; }));
    if (!options.html.empty()) write_page(options, all);
    return failures == 0 ? 0 : 1;
}

}

int main(int count, char** words)
{
    Options options;
    CLI::App parser("References and textbook formulas against oracles on hard inputs.", "umbral bench stability");
    parser.add_option("--questions", options.questions, "For each function")
        ->check(CLI::Range(1U, 100000000U))
        ->capture_default_str();
    parser.add_option("--seed", options.seed, "Of the questions")->capture_default_str();
    parser.add_option("--html", options.html, "Write a page whose rows open their worst questions");
    parser.add_flag("--quick", options.quick, "2000 questions a function");
    parser.add_flag("--verdicts", options.verdicts, "Only which functions keep their bounds, one a line");
    try {
        parser.parse(count, words);
    } catch (const CLI::ParseError& error) {
        return parser.exit(error) == 0 ? 0 : 2;
    }
    try {
        return run(options);
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral bench stability: %s\n", error.what());
        return 3;
    }
}
