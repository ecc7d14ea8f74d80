#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// Where the program behind a benchmark comes from.
enum class BenchmarkHome {
    command,  ///< it is a command of umbral itself
    package,  ///< a program that instructors' packages hold too
    sources,  ///< a program, or a script, of the checkout alone
    tests,    ///< a program among the tests: its target is there only if the build was configured with them
};

/// What a program is given.
struct BenchmarkCall {
    std::vector<std::string> words;      ///< "@/" at the beginning of a word stands for the folder of the sources
    std::vector<std::string> variables;  ///< "NAME=value"; what the caller's environment says already stays
};

/// What measures something of which a document shows figures.
struct Benchmark {
    std::string name;                      ///< as in `umbral bench NAME`
    std::string measures;                  ///< what, in one line
    BenchmarkHome home;                    ///< decides how its program is found
    std::string program = {};              ///< its target, which is its file's name too; of a script its path
    std::vector<std::string> always = {};  ///< words that begin every call
    BenchmarkCall usual = {};  ///< what follows if the caller says nothing else: made the documents' figures
    std::optional<BenchmarkCall> quick =
        {};                 ///< what follows with --quick, for some seconds; none: it takes minutes anyway
    bool has_help = false;  ///< its --help says what it can be told
};

/// All of them, in the order in which they are listed.
[[nodiscard]] std::span<const Benchmark> benchmarks();

/// The one of this name; null if there is none.
[[nodiscard]] const Benchmark* find_benchmark(std::string_view name);

/// What `umbral bench` prints without a name.
[[nodiscard]] std::string list_of_benchmarks();

/// How one of them is called and what it is given, for those whose program has no --help of its own.
[[nodiscard]] std::string help_of(const Benchmark& benchmark);

}
