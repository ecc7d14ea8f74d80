#include "judge/rows/alignment.hpp"

#include <algorithm>
#include <cstdint>

namespace umbral::grader {
namespace {

using Same = std::function<bool(std::size_t, std::size_t)>;
constexpr std::int64_t nowhere = -1;
constexpr std::size_t most_work = 200'000'000;  // steps for both sequences together, about a second

/// Furthest points in a (x) that are reached with d differences, by diagonal k = x - y from -d to d in steps of two.
class Front {
public:
    explicit Front(std::int64_t d) : d_(d), furthest_(static_cast<std::size_t>(d) + 1, nowhere) {}
    [[nodiscard]] std::int64_t at(std::int64_t k) const
    {
        return k < -d_ || k > d_ ? nowhere : furthest_[static_cast<std::size_t>((k + d_) / 2)];
    }
    void set(std::int64_t k, std::int64_t x) { furthest_[static_cast<std::size_t>((k + d_) / 2)] = x; }

private:
    std::int64_t d_;
    std::vector<std::int64_t> furthest_;
};

/// Where diagonal k is entered from the front before: by passing over an element of a, or of b. `nowhere` if it cannot
/// be.
struct Entry {
    std::int64_t x = nowhere;
    bool passes_a = false;
};

Entry entry(const Front& before, std::int64_t k, std::int64_t size_a, std::int64_t size_b)
{
    const std::int64_t left = before.at(k - 1);
    const std::int64_t above = before.at(k + 1);
    const std::int64_t over_a = left != nowhere && left < size_a ? left + 1 : nowhere;
    const std::int64_t over_b = above != nowhere && above - k <= size_b ? above : nowhere;
    return over_a > over_b ? Entry{over_a, true} : Entry{over_b, false};
}

/// One search from a starting point, at most `limit` differences far. Appends its matches, and moves the starting point
/// to where it ended. Returns whether it came to the end of both sequences.
class Search {
public:
    Search(std::size_t& start_a, std::size_t& start_b, std::size_t end_a, std::size_t end_b, const Same& same)
        : start_a_(start_a),
          start_b_(start_b),
          a_(static_cast<std::int64_t>(end_a - start_a)),
          b_(static_cast<std::int64_t>(end_b - start_b)),
          same_(same)
    {
    }

    bool run(std::int64_t limit, std::vector<std::pair<std::size_t, std::size_t>>& matches)
    {
        for (std::int64_t d = 0; d <= limit; ++d) {
            fronts_.emplace_back(d);
            for (std::int64_t k = -d; k <= d; k += 2) {
                std::int64_t x = d == 0 ? 0 : entry(fronts_[static_cast<std::size_t>(d) - 1], k, a_, b_).x;
                if (x == nowhere) continue;
                while (x < a_ && x - k < b_ &&
                       same_(start_a_ + static_cast<std::size_t>(x), start_b_ + static_cast<std::size_t>(x - k)))
                    ++x;
                fronts_.back().set(k, x);
                if (x == a_ && x - k == b_) {
                    trace_back(d, k, matches);
                    return true;
                }
            }
        }
        std::int64_t best = -limit;
        for (std::int64_t k = -limit; k <= limit; k += 2)
            if (2 * fronts_.back().at(k) - k > 2 * fronts_.back().at(best) - best && fronts_.back().at(k) != nowhere)
                best = k;
        trace_back(limit, best, matches);
        return false;
    }

private:
    void trace_back(std::int64_t d, std::int64_t k, std::vector<std::pair<std::size_t, std::size_t>>& matches)
    {
        const std::size_t old = matches.size();
        const std::int64_t end = fronts_[static_cast<std::size_t>(d)].at(k);
        const std::int64_t end_b = end - k;
        for (std::int64_t x = end; d >= 0; --d) {
            const Entry from = d == 0 ? Entry{0, false} : entry(fronts_[static_cast<std::size_t>(d) - 1], k, a_, b_);
            for (; x > from.x; --x)
                matches.emplace_back(start_a_ + static_cast<std::size_t>(x - 1),
                                     start_b_ + static_cast<std::size_t>(x - k - 1));
            x = from.passes_a ? from.x - 1 : from.x;
            k += from.passes_a ? -1 : 1;
        }
        std::reverse(matches.begin() + static_cast<std::ptrdiff_t>(old), matches.end());
        start_a_ += static_cast<std::size_t>(end);
        start_b_ += static_cast<std::size_t>(end_b);
    }

    std::size_t& start_a_;
    std::size_t& start_b_;
    std::int64_t a_;
    std::int64_t b_;
    const Same& same_;
    std::vector<Front> fronts_;
};

}

Alignment align(std::size_t size_a, std::size_t size_b, const Same& same)
{
    const auto limit = static_cast<std::int64_t>(std::clamp<std::size_t>(most_work / (size_a + size_b + 1), 64, 2048));
    Alignment alignment;
    std::size_t a = 0;
    std::size_t b = 0;
    while (!Search(a, b, size_a, size_b, same).run(limit, alignment.matches)) alignment.best = false;
    return alignment;
}

}
