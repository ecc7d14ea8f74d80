#include "measurement.hpp"

#include <algorithm>
#include <stdexcept>

namespace umbral::bench {
namespace {

template <class Entry>
const Entry& entry(const std::vector<Entry>& entries, const std::string& id, const std::string& of)
{
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& one) { return one.id == id; });
    if (found == entries.end()) throw std::out_of_range("the knob " + of + " has no '" + id + "'");
    return *found;
}

}

std::vector<Result> results_in(const Knob& knob, const std::string& situation)
{
    std::vector<Result> some;
    std::copy_if(knob.results.begin(), knob.results.end(), std::back_inserter(some),
                 [&](const Result& one) { return one.situation == situation; });
    return some;
}

const Measure& measure_of(const Knob& knob, const std::string& id) { return entry(knob.measures, id, knob.id); }
const Situation& situation_of(const Knob& knob, const std::string& id) { return entry(knob.situations, id, knob.id); }

}
