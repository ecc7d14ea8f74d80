#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <umbral/record/cost.hpp>
#include <umbral/record/questions.hpp>

#include "run/fresh_memory.hpp"

namespace umbral::grader {

/// What one run is to do, as its spawner was told (RunRequest).
struct Job {
    std::string case_name;
    std::uint64_t stream = 0;  ///< what the case's random numbers follow from
    std::string driver;
    std::string solution;  ///< empty for a unit without C++
    std::string used;      ///< a library whose functions the solution calls; empty for none
    std::uint64_t memory = 0;
    std::uint64_t cpu_seconds = 0;
    CostLimit costs;  ///< without a table all costs are worked on
    Inquiry inquiry;
    PassedOver passed_over;
    std::optional<std::uint64_t> beside;  ///< as `stream`, of the cases that run beside this one
    unsigned mutant = 0;                  ///< of a library that holds mutants, which only trusted ones do; 0 for none
    FreshMemory fresh_memory = FreshMemory::nonsense;  ///< what memory holds that was never written
};

/// Reads what spawner.cpp writes. Throws nlohmann::json::exception for any other text.
[[nodiscard]] Job job_from(const std::string& text);

}
