#include "cli/authors/idle.hpp"

#include <fmt/format.h>

#include <mutex>

#include "cli/checkout.hpp"
#include "model/one_cpp_file.hpp"
#include "mutants/idle_unit.hpp"
#include "report/paint.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {

void validate_idle(Application& application, const std::vector<std::string>& units, std::size_t jobs, bool quiet)
{
    const Paint paint(application.style);
    application.require_answers();
    std::vector<Exercise> exercises = units.empty() ? application.readable() : application.chosen(units);
    std::erase_if(exercises, [](const Exercise& exercise) { return !is_one_cpp_file(exercise); });
    const std::filesystem::path finder = have_finder(application, "validate --idle finds functions");
    have_built(application, exercises, UnitParts::answers);
    std::mutex mutex;
    std::size_t earning = 0;
    Crew(application.tools, jobs).share_out(exercises.size(), [&](Worker& worker, std::size_t index) {
        for (const auto& [family, gives] : {std::pair(MutantFamily::idle, "gives nothing"),
                                            std::pair(MutantFamily::echo, "gives back what it was given")}) {
            const IdleUnit idle = try_idle(worker, finder, exercises[index], 0, family);
            const std::lock_guard lock(mutex);
            earning += idle.holds() ? 0 : 1;
            if (quiet && idle.holds()) continue;
            fmt::print("{:<32} {:<28} {:5.1f} % {}\n", idle.unit, gives, idle.credit, paint.safe(idle.trouble));
            for (const std::string& check : idle.earning) fmt::print("    {}\n", check);
            (void)std::fflush(stdout);
        }
    });
    fmt::print("{} units; {} programs that do nothing earn more than {:g} %, or {:g} % by giving back questions\n",
               exercises.size(), earning, most_idle_credit(MutantFamily::idle), most_idle_credit(MutantFamily::echo));
    if (earning > 0) application.exit_status = exit_not_right;
}

}
