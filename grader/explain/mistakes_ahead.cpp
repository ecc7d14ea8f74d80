#include "explain/mistakes_ahead.hpp"

#include <system_error>
#include <utility>

namespace umbral::grader {

MistakesAhead::MistakesAhead(Worker& worker, const Exercise& exercise, const std::string& case_name, std::uint64_t seed,
                             std::vector<const KnownSolution*> mistakes)
{
    Worker* const second = mistakes.size() > 1 ? worker.second() : nullptr;
    if (second == nullptr) return;
    const auto begin_with_last = [second, &exercise, &case_name, seed,
                                  all = std::move(mistakes)](const std::stop_token& stop) {
        try {
            for (auto one = all.rbegin(); one != all.rend() && !stop.stop_requested(); ++one)
                (void)second->run_known(exercise, **one, case_name, seed);
        } catch (...) {
            // The first worker comes to the same.
        }
    };
    try {
        ahead_ = std::jthread(begin_with_last);
    } catch (const std::system_error&) {
        // No more threads to be had.
    }
}

}
