#include "explain/mistakes_ahead.hpp"

#include <utility>

#include "worker/thread_or_none.hpp"

namespace umbral::grader {

MistakesAhead::MistakesAhead(Worker& worker, const Exercise& exercise, const std::string& case_name, std::uint64_t seed,
                             std::vector<const KnownSolution*> mistakes)
{
    Worker* const second = mistakes.size() > 1 ? worker.second() : nullptr;
    if (second == nullptr) return;
    ahead_ =
        thread_or_none([second, &exercise, &case_name, seed, all = std::move(mistakes)](const std::stop_token& stop) {
            try {
                for (auto one = all.rbegin(); one != all.rend() && !stop.stop_requested(); ++one)
                    (void)second->run_known(exercise, **one, case_name, seed);
            } catch (...) {
                // The first worker comes to the same.
            }
        });
}

}
