#include "report/clusters.hpp"

#include <algorithm>
#include <map>

#include "report/hidden.hpp"
#include "report/reasons.hpp"

namespace umbral::grader {
namespace {

bool needs_a_reason(const UnitResult& unit)
{
    const bool nothing_there = unit.verdict == Verdict::missing || unit.verdict == Verdict::not_implemented ||
                               unit.verdict == Verdict::grader_fault;
    return !nothing_there && !all_right(unit);
}

/// Clusters under one name each, with the confidence of every member.
class Collection {
public:
    void add(const std::string& name, std::span<const Explanation> reasons, std::size_t who)
    {
        Entry& entry = by_name_[name];
        if (entry.cluster.who.empty()) {
            entry.cluster.name = name;
            for (const Explanation& reason : reasons) entry.cluster.sentences.push_back(reason.sentence);
        }
        entry.cluster.who.push_back(who);
        if (!reasons.empty()) entry.confidences.push_back(reasons.front().confidence);
    }

    std::vector<Cluster> take()
    {
        std::vector<Cluster> all;
        for (auto& [name, entry] : by_name_) {
            std::ranges::sort(entry.confidences);
            if (!entry.confidences.empty()) entry.cluster.confidence = entry.confidences[entry.confidences.size() / 2];
            all.push_back(std::move(entry.cluster));
        }
        std::ranges::stable_sort(all, std::ranges::greater{},
                                 [](const Cluster& cluster) { return cluster.who.size(); });
        return all;
    }

private:
    struct Entry {
        Cluster cluster;
        std::vector<double> confidences;
    };
    std::map<std::string, Entry> by_name_;
};

struct Collections {
    std::size_t graded = 0;
    Collection explained;
    Collection ambiguous;
    Collection unexplained;
    std::vector<std::size_t> missing;

    void add(const UnitResult& unit, std::size_t who)
    {
        if (unit.verdict != Verdict::grader_fault) ++graded;
        if (unit.verdict == Verdict::missing) missing.push_back(who);
        if (!needs_a_reason(unit)) return;
        const std::span<const Explanation> reasons = main_reasons(unit);
        std::vector<std::string> names;
        for (const Explanation& reason : reasons) names.push_back(readable_reason(reason));
        // The order of equals says nothing.
        std::ranges::sort(names);
        std::string name;
        for (const std::string& one : names) name += (name.empty() ? "" : " or ") + one;
        const bool ran =
            unit.verdict == Verdict::partial || unit.verdict == Verdict::wrong || unit.verdict == Verdict::ok;
        if (reasons.empty())
            unexplained.add(ran ? "no explanation" : std::string(in_words(unit.verdict)), reasons, who);
        else
            (reasons.size() > 1 ? ambiguous : explained).add(name, reasons, who);
    }
};

}

std::size_t UnitClusters::submissions() const
{
    std::size_t sum = 0;
    for (const auto* kind : {&explained, &ambiguous, &unexplained})
        for (const Cluster& cluster : *kind) sum += cluster.who.size();
    return sum;
}

std::vector<UnitClusters> clusters(const ClassResult& result)
{
    std::map<std::string, Collections> by_unit;
    for (std::size_t s = 0; s < result.submissions.size(); ++s)
        for (const UnitResult& unit : result.submissions[s].units) by_unit[unit.id].add(unit, s);
    std::vector<UnitClusters> all;
    for (auto& [id, one] : by_unit)
        all.push_back(
            {id, one.graded, one.explained.take(), one.ambiguous.take(), one.unexplained.take(), one.missing});
    std::erase_if(all, [](const UnitClusters& unit) { return unit.submissions() == 0 && unit.missing.empty(); });
    std::ranges::stable_sort(all, std::ranges::greater{}, &UnitClusters::submissions);
    return all;
}

}
