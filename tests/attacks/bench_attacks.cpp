#include <fmt/format.h>

#include <exception>
#include <string_view>

#include "attack/findings.hpp"
#include "support/temporary_folder.hpp"

// Prints what a class of 50 costs, without attacks and with ten of the costliest in it; not a test. With --quick the
// class is as small as it can be, and one attack is in it.
int main(int count, char** words)
{
    using namespace umbral::grader::attack;
    try {
        const std::filesystem::path source = UMBRAL_SOURCE;
        const bool quick = count > 1 && std::string_view(words[1]) == "--quick";
        std::vector<Attack> worst;
        for (const char* const name :
             {"running/hangs-in-every-case", "running/just-under-the-limit", "running/memory-to-the-limit",
              "running/forge-rows-with-presence", "compiler/template-doubling", "compiler/include-tree",
              "symbols/doubling-definition", "judges/events-in-floods", "shaders/endless-loop", "folders/many-files"})
            worst.push_back(load_attack(source / "tests" / "attacks" / name));
        if (quick) worst = {load_attack(source / "tests" / "attacks" / "running/forge-rows-with-presence")};
        const std::vector<std::string> units = units_of(worst);
        fmt::print("| class{} | seconds | grader's memory, MiB | cache, MiB | reports, MiB |\n|---|---|---|---|---|\n",
                   quick ? "" : " of 50");
        for (const bool attacked : {false, true}) {
            const umbral::test::TemporaryFolder scratch;
            const Target target{UMBRAL_PROGRAM, source / "reference", source / "exercises", source / "tests" / "class",
                                quick      ? 0
                                : attacked ? 37
                                           : 47};
            const Graded graded =
                grade_beside_good(target, {}, attacked ? std::span<const Attack>(worst) : std::span<const Attack>(),
                                  units, scratch.path());
            if (!graded.complete()) fmt::print("{}\n", graded.how_it_ended());
            fmt::print("| {} | {:.0f} | {:.0f} | {:.1f} | {:.1f} |\n",
                       !attacked ? "good work alone"
                       : quick   ? "one attack in it"
                                 : "ten of the costliest attacks in it",
                       graded.run.seconds, graded.run.peak_mib, graded.cache_kib / 1024, graded.reports_kib / 1024);
            (void)std::fflush(stdout);
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
