#include <fmt/format.h>

#include <exception>

#include "attack/findings.hpp"
#include "support/temporary_folder.hpp"

// Prints what a class of 50 costs, without attacks and with ten of the costliest in it; not a test.
int main()
{
    using namespace umbral::grader::attack;
    try {
        const std::filesystem::path source = UMBRAL_SOURCE;
        std::vector<Attack> worst;
        for (const char* const name : {"running/hangs-in-every-case", "running/just-under-the-limit", "running/memory-to-the-limit",
                                       "running/forge-rows-with-presence", "compiler/template-doubling", "compiler/include-tree", "symbols/doubling-definition",
                                       "judges/events-in-floods", "shaders/endless-loop", "folders/many-files"})
            worst.push_back(load_attack(source / "tests" / "attacks" / name));
        const std::vector<std::string> units = units_of(worst);
        fmt::print("| class of 50 | seconds | grader's memory, MiB | cache, MiB | reports, MiB |\n|---|---|---|---|---|\n");
        for (const bool attacked : {false, true}) {
            const umbral::test::TemporaryFolder scratch;
            const Target target{UMBRAL_PROGRAM, source / "reference", source / "exercises", source / "tests" / "class", attacked ? 37 : 47};
            const Graded graded = grade_beside_good(target, {}, attacked ? std::span<const Attack>(worst) : std::span<const Attack>(), units, scratch.path());
            if (!graded.complete()) fmt::print("{}\n", graded.how_it_ended());
            fmt::print("| {} | {:.0f} | {:.0f} | {:.1f} | {:.1f} |\n", attacked ? "ten of the costliest attacks in it" : "good work alone", graded.run.seconds,
                       graded.run.peak_mib, graded.cache_kib / 1024, graded.reports_kib / 1024);
            (void)std::fflush(stdout);
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
