#pragma once

#include <stdexcept>

namespace umbral::grader {

/// A folder for reports that cannot be used as the user asked. The text says why, and what to do.
class RefusedFolder : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}
