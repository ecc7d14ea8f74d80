#pragma once

#include <map>
#include <optional>
#include <string>

#include "judge/evidence/evidence.hpp"

namespace umbral::grader::html {

/// What the manifest says of a check, and what its run showed.
struct CheckDetail {
    std::string why{};              ///< where its tolerance comes from
    std::string bound{};            ///< "4 ulp": what is allowed, in words
    std::optional<double> limit{};  ///< the same in the unit of the error
    std::string unit{};             ///< of the error: "ulp"
    Evidence evidence{};
    bool practice = false;  ///< the evidence is of a run with practice inputs, which are not graded
};

struct UnitDetail {
    std::string title;
    std::map<std::string, CheckDetail> checks;      ///< by name
    std::map<std::string, CheckDetail> practice{};  ///< in place of these, what students see of hidden checks
};

/// Details of a submission's units, by id.
using UnitDetails = std::map<std::string, UnitDetail>;

}
