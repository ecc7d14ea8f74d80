#pragma once

#include "worker/spare_time.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Takes from a time what a worker's runs take as long as this lives.
class SpentOnRuns {
public:
    SpentOnRuns(SpareTime& time, const Worker& worker) : time_(time), worker_(worker) {}
    SpentOnRuns(const SpentOnRuns&) = delete;
    SpentOnRuns& operator=(const SpentOnRuns&) = delete;
    ~SpentOnRuns() { time_.spend(worker_.run_seconds() - before_); }

private:
    SpareTime& time_;
    const Worker& worker_;
    double before_ = worker_.run_seconds();
};

}
