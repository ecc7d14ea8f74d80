#include "cli/authors/gaps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <mutex>

#include "cli/checkout.hpp"
#include "report/paint.hpp"
#include "validate/unit_gaps.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {

void print_gaps(Application& application, const std::vector<std::string>& units, std::size_t jobs, unsigned seeds)
{
    const Paint paint(application.style);
    application.require_answers();
    const std::vector<Exercise> exercises = units.empty() ? application.readable() : application.chosen(units);
    have_built(application, exercises, UnitParts::answers);
    std::mutex mutex;
    Crew(application.tools, jobs).share_out(exercises.size(), [&](Worker& worker, std::size_t index) {
        const Exercise& exercise = exercises[index];
        const std::vector<FunctionGaps> found = unit_gaps(worker, exercise, seeds);
        const std::lock_guard lock(mutex);
        fmt::print("{}\n", exercise.id);
        for (const FunctionGaps& function : found) {
            fmt::print("  {}: {} calls\n", paint.safe(function.function), function.calls);
            for (const InputGap& gap : function.gaps)
                fmt::print("    {}: {}\n", gap.what, paint.safe(fmt::format("{}", fmt::join(gap.where, ", "))));
        }
        (void)std::fflush(stdout);
    });
}

}
