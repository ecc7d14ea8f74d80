#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "build/builder.hpp"
#include "build/inspection.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What one question came through.
struct PassedByOne {
    std::vector<std::uint32_t> places{};  ///< by number, in the order in which it first did
    bool by_exception = false;            ///< an exception ended it
};

using PlacesOfQuestions = std::map<std::uint32_t, PassedByOne>;

/// What a traced run took down under this name (umbral/record/block_trace.hpp), row by row; empty where its recording
/// holds none, or what no run of ours writes.
[[nodiscard]] std::vector<std::uint32_t> traced_numbers(const RunOutcome& run, std::string_view name,
                                                        std::uint32_t components);

/// places_of() for blocks of a traced build, within its budget.
[[nodiscard]] std::vector<std::optional<SourcePlace>> places_in(const Worker& worker, const Built& traced,
                                                                std::span<const std::uint32_t> blocks);

/// Runs of what was built to be traced (build/traced.hpp), and the places in the student's files behind their blocks.
/// Each run is made once.
class TracedRuns {
public:
    /// The others must live as long. For so many seconds, which runs of any kind take, there is time.
    TracedRuns(Worker& worker, const Exercise& exercise, const Built& traced, double seconds)
        : worker_(worker), exercise_(exercise), traced_(traced), end_(worker.run_seconds() + seconds)
    {
    }

    [[nodiscard]] bool has_time() const
    {
        return is_readable_ && worker_.spare_time().is_left() && worker_.run_seconds() < end_;
    }

    /// Of a run with the inputs of a seed, if it records the same as `plain` did of the check's value; null if it does
    /// not.
    [[nodiscard]] const PlacesOfQuestions* places(const Check& check, std::uint64_t seed, const RunOutcome& plain);

    [[nodiscard]] const SourcePlace& place(std::uint32_t number) const { return places_.at(number); }

private:
    struct Run {
        RunOutcome outcome;
        PlacesOfQuestions places;
    };

    [[nodiscard]] PlacesOfQuestions placed(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& blocks);
    void look_up(const std::vector<std::uint32_t>& blocks);

    Worker& worker_;
    const Exercise& exercise_;
    const Built& traced_;
    double end_;
    bool is_readable_ = true;  ///< its debug information, in the time that there is for it
    std::map<std::pair<std::string, std::uint64_t>, Run> runs_;
    std::map<std::uint32_t, std::optional<std::uint32_t>> numbers_;  ///< of blocks, by their addresses
    std::vector<SourcePlace> places_;
};

}
