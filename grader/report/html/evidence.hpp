#pragma once

#include <map>
#include <optional>
#include <string>

#include "judge/evidence/evidence.hpp"

namespace umbral::grader::html {

/// What the manifest says of a check, and what its run showed.
struct CheckDetail {
    std::string why;              ///< where its tolerance comes from
    std::string bound;            ///< "4 ulp": what is allowed, in words
    std::optional<double> limit;  ///< the same in the unit of the error
    std::string unit;             ///< of the error: "ulp"
    Evidence evidence;
};

struct UnitDetail {
    std::string title;
    std::map<std::string, CheckDetail> checks;  ///< by name
};

/// Details of a submission's units, by id.
using UnitDetails = std::map<std::string, UnitDetail>;

}
