#include "cli/authors/benchmarks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace umbral::grader {
namespace {

using enum BenchmarkHome;

std::vector<Benchmark> make_benchmarks()
{
    const BenchmarkCall flag{{"--quick"}, {}};
    const BenchmarkCall terse{{"--gtest_brief=1"}, {}};
    const auto triangles = [&](const char* count) {
        return BenchmarkCall{terse.words, {std::string("UMBRAL_COVERAGE_TRIANGLES=") + count}};
    };
    return {
        {.name = "accuracy",
         .measures = "what accuracy costs in time: a page with curves and their knees",
         .home = package,
         .program = "umbral-bench-accuracy",
         .always = {"accuracy"},
         .quick = flag,
         .has_help = true},
        {.name = "judges",
         .measures = "how often the judge of pictures is right, beside RMSE, SSIM and others",
         .home = command,
         .always = {"bench", "judges"},
         .quick = flag,
         .has_help = true},
        {.name = "explanations",
         .measures = "how often the right reason is given for a mistake, and a wrong one",
         .home = command,
         .always = {"bench", "explanations"},
         .quick = flag,
         .has_help = true},
        {.name = "unforeseen",
         .measures = "what is said of bugs that are in no list, and whether it is true",
         .home = command,
         .always = {"bench", "unforeseen"},
         .quick = flag,
         .has_help = true},
        {.name = "findings",
         .measures = "what validate finds in all units",
         .home = command,
         .always = {"validate", "--quiet"},
         .usual = {{"--seeds", "5"}, {}},
         .quick = BenchmarkCall{{"--seeds", "1", "sphere"}, {}},
         .has_help = true},
        {.name = "check",
         .measures = "how long `umbral check` takes: never built before, unchanged, from a save to its verdict",
         .home = tests,
         .program = "bench-check",
         .quick = flag},
        {.name = "run",
         .measures = "what one sandboxed run costs, beside a bare fork",
         .home = tests,
         .program = "bench-run",
         .quick = flag},
        {.name = "image-judge",
         .measures = "processor time of the judges of pictures, 512 x 512",
         .home = tests,
         .program = "bench-image-judge",
         .quick = flag},
        {.name = "renderers",
         .measures = "how far the engine's renderers are apart on all scenes, and why",
         .home = command,
         .always = {"render", "@/reference/scenes", "--compare"},
         .quick = BenchmarkCall{{"--size", "256x256"}, {}},
         .has_help = true},
        {.name = "effects",
         .measures =
             "what it saves, per scene and renderer, to draw without the effects that a scene does not call for",
         .home = sources,
         .program = "bench-effects",
         .always = {"@/reference/scenes"},
         .quick = BenchmarkCall{{"--rounds", "1", "--size", "64"}, {}},
         .has_help = true},
        {.name = "budget",
         .measures = "pictures asked for by error or time: predicted, measured, and beside the best setting by search",
         .home = sources,
         .program = "bench-budget",
         .always = {"@/reference/scenes"},
         .quick = flag,
         .has_help = true},
        {.name = "agreement",
         .measures = "lit scenes drawn by OpenGL's fixed function, by shaders and in software, and why they differ",
         .home = tests,
         .program = "lighting-agreement",
         .quick = flag},
        {.name = "raster",
         .measures = "the engine's rasteriser against Mesa's llvmpipe, in time",
         .home = sources,
         .program = "bench-raster",
         .quick = BenchmarkCall{{"--seconds", "0.05", "--legs", "8", "64"}, {}},
         .has_help = true},
        {.name = "stability",
         .measures =
             "references and textbook formulas against oracles on hard inputs; relations; finite in, finite out",
         .home = sources,
         .program = "umbral-bench-stability",
         .quick = flag,
         .has_help = true},
        {.name = "compilers",
         .measures = "the same verdicts by g++ and clang++ at -O0, -O3 -march=native and with contraction",
         .home = sources,
         .program = "reference/bench/stability/compilers",
         .quick = BenchmarkCall{{"gcc-O0"}, {}}},
        {.name = "rays",
         .measures = "the engine's ray tracer beside Embree: building, and rays of four kinds, in time",
         .home = tests,
         .program = "bench-rays",
         .quick = flag},
        {.name = "coverage",
         .measures = "which pixels triangles cover: the reference against Mesa",
         .home = tests,
         .program = "coverage-test",
         .usual = terse,
         .quick = terse},
        {.name = "raster-coverage",
         .measures =
             "the same of the engine, a million triangles; the variable UMBRAL_COVERAGE_TRIANGLES says how many",
         .home = tests,
         .program = "raster-coverage-test",
         .usual = triangles("1000000"),
         .quick = triangles("20000")},
        {.name = "textures",
         .measures = "texture lookups: the reference against Mesa",
         .home = tests,
         .program = "texture-sampling-test",
         .usual = terse,
         .quick = terse},
        {.name = "sphere",
         .measures = "ray against sphere: how far reference and school formula lie from the truth; SEED, RAYS",
         .home = tests,
         .program = "sphere-accuracy",
         .usual = {{"3", "3000000"}, {}},
         .quick = BenchmarkCall{{"3", "3000"}, {}}},
        {.name = "attacks",
         .measures = "what a class of 50 costs, and what ten of the costliest attacks add to it",
         .home = tests,
         .program = "bench-attacks",
         .quick = flag},
        {.name = "class",
         .measures = "what a class of 200 costs that hands in ten units each, cold and unchanged; STUDENTS, SEED, "
                     "percent of wrong ones",
         .home = sources,
         .program = "tests/cost/class",
         .quick = flag,
         .has_help = true},
        {.name = "outcomes",
         .measures = "whether every attack has the outcome that it must have, beside good work whose grade stays",
         .home = tests,
         .program = "attacks-test",
         .usual = {terse.words, {"UMBRAL_ATTACKS=all"}}},
        {.name = "fuzz",
         .measures = "the reader and writer of PLY files under libFuzzer; SECONDS, TARGET",
         .home = sources,
         .program = "tests/fuzz/run",
         .usual = {{"600", "ply"}, {}},
         .quick = BenchmarkCall{{"5", "ply"}, {}}},
    };
}

std::string call_text(const BenchmarkCall& call)
{
    std::vector<std::string> all = call.variables;
    all.insert(all.end(), call.words.begin(), call.words.end());
    return all.empty() ? "nothing" : fmt::format("`{}`", fmt::join(all, " "));
}

}

std::span<const Benchmark> benchmarks()
{
    static const std::vector<Benchmark> all = make_benchmarks();
    return all;
}

const Benchmark* find_benchmark(std::string_view name)
{
    const std::span<const Benchmark> all = benchmarks();
    const auto found = std::ranges::find(all, name, &Benchmark::name);
    return found == all.end() ? nullptr : &*found;
}

std::string list_of_benchmarks()
{
    std::string text =
        "umbral bench NAME measures one of these, and builds what that needs. `--quick` is a look of some seconds; any "
        "other words\n"
        "are handed on in place of the usual ones; `umbral bench NAME --help` says which there are.\n\n";
    for (const Benchmark& one : benchmarks()) text += fmt::format("  {:16} {}\n", one.name, one.measures);
    return text;
}

std::string help_of(const Benchmark& benchmark)
{
    std::string text = fmt::format("umbral bench {}: {}.\nIt starts {}, which is given {} if nothing else is said",
                                   benchmark.name, benchmark.measures, benchmark.program, call_text(benchmark.usual));
    if (benchmark.quick && !benchmark.quick->words.empty())
        text += fmt::format(", and with --quick {}", call_text(*benchmark.quick));
    return text + (benchmark.quick ? ".\n" : ". It has no --quick: it takes minutes in any case.\n");
}

}
