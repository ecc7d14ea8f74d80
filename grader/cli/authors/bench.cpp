#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>

#include "cli/application.hpp"
#include "cli/authors/benchmarks.hpp"
#include "cli/authors/commands.hpp"
#include "cli/checkout.hpp"
#include "cli/replace_process.hpp"
#include "model/nearest.hpp"

namespace umbral::grader {
namespace {

bool take(std::vector<std::string>& words, std::string_view wanted) { return std::erase(words, wanted) > 0; }

const Benchmark& benchmark_named(const std::string& name)
{
    if (const Benchmark* const found = find_benchmark(name)) return *found;
    std::vector<std::string> known;
    for (const Benchmark& one : benchmarks()) known.push_back(one.name);
    throw UsageError(fmt::format("expected the name of a benchmark, and got '{}'{} `umbral bench` lists them all", name,
                                 did_you_mean(nearest(name, known))));
}

/// The program's path, up to date.
std::string program_of(const Application& application, const Benchmark& benchmark)
{
    switch (benchmark.home) {
        case BenchmarkHome::command: return (application.tools.programs / "umbral").string();
        case BenchmarkHome::package:
            if (application.layout.installed) return have_program(application, benchmark.program).string();
            break;
        case BenchmarkHome::sources:
        case BenchmarkHome::tests: break;
    }
    if (application.layout.installed)
        throw UsageError(
            fmt::format("umbral bench {} needs the checkout: packages do not hold {}; get the sources, and call "
                        "./umbral bench {} there",
                        benchmark.name, benchmark.program, benchmark.name));
    if (benchmark.program.find('/') != std::string::npos) return (application.layout.data / benchmark.program).string();
    return have_fresh_program(application, benchmark.program, benchmark.home == BenchmarkHome::tests).string();
}

[[noreturn]] void start(const Application& application, const Benchmark& benchmark, std::vector<std::string> given)
{
    const bool quick = take(given, "--quick");
    if (quick && !benchmark.quick)
        throw UsageError(fmt::format("umbral bench {} has no --quick: it takes minutes in any case", benchmark.name));
    std::vector<std::string> words{program_of(application, benchmark)};
    words.insert(words.end(), benchmark.always.begin(), benchmark.always.end());
    const BenchmarkCall& call = quick ? *benchmark.quick : benchmark.usual;
    if (quick || given.empty()) words.insert(words.end(), call.words.begin(), call.words.end());
    words.insert(words.end(), given.begin(), given.end());
    for (std::string& word : words)
        if (word.starts_with("@/")) word = (application.layout.data / word.substr(2)).string();
    for (const std::string& variable : call.variables) {
        const std::size_t equals = variable.find('=');
        (void)setenv(variable.substr(0, equals).c_str(), variable.c_str() + equals + 1, 0);
    }
    replace_process(std::move(words), "call ./umbral test, which builds everything");
}

}

// What measures the grader itself are commands; all else is a program of its own, with options of its own, that knows
// what the grader must not hold: the reference.
void add_bench(Command command, Application& application)
{
    command.passes_words_on();
    add_bench_explanations(command, application);
    add_bench_judges(command, application);
    add_bench_unforeseen(command, application);
    command.runs([&application, command] {
        if (command.has_named_command()) return;
        std::vector<std::string> words = command.rest();
        if (words.empty() || words.front() == "--help" || words.front() == "-h")
            return fmt::print("{}", list_of_benchmarks());
        const Benchmark& benchmark = benchmark_named(words.front());
        words.erase(words.begin());
        if (!benchmark.has_help && (take(words, "--help") || take(words, "-h")))
            return fmt::print("{}", help_of(benchmark));
        start(application, benchmark, std::move(words));
    });
}

}
