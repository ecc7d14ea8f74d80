#pragma once

#include <functional>
#include <string>
#include <vector>

#include "explain/asked_sample.hpp"

namespace umbral::grader {

/// Checks of other visible cases, as far as these ran to their ends: first of what is recorded under the same name, and
/// is asked alike, as a rule. Not of pictures.
[[nodiscard]] std::vector<const Check*> checks_beside(const Exercise& exercise, const CaseResults& cases,
                                                      const Check& check);

/// What other visible cases answer to questions of the function that a check's are, right or wrong; found out once for
/// each, when first asked for.
class OtherCases {
public:
    /// Both others must live as long.
    OtherCases(Worker& worker, const AskedCheck& asked) : worker_(worker), asked_(asked) {}

    /// Calls `look` with the answers of each case, until it says that no more is wanted.
    void each(const std::string& function, const std::function<bool(const AskedSample&)>& look);

private:
    Worker& worker_;
    const AskedCheck& asked_;
    std::vector<AskedSample> known_;
    bool are_all_ = false;
};

}
