#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "run/spawner.hpp"

namespace umbral::grader {

/// Runs of trusted code that several workers remember together: each is made once, by whoever asks for it first, and
/// who asks meanwhile waits for it. For use by several threads at once.
class SharedRuns {
public:
    using Run = std::shared_ptr<const RunOutcome>;

    /// The run that this key stands for, made by `make` if nobody has yet. What `make` throws all get who wait for it;
    /// it is tried again for the next. `make` may ask for other runs, as long as none of these asks for this one.
    [[nodiscard]] Run get(const std::string& key, const std::function<RunOutcome()>& make);

private:
    void forget(const std::string& key);
    void count(const RunOutcome& outcome);

    std::mutex mutex_;
    std::map<std::string, std::shared_future<Run>> runs_;
    std::size_t bytes_ = 0;
};

}
