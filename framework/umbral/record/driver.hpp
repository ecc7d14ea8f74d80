#pragma once

#include <umbral/record/case.hpp>
#include <umbral/record/recorder.hpp>
#include <vector>

namespace umbral {

/// One named case of a unit: calls the unit's functions and records what they give.
struct DriverCase {
    const char* name;
    void (*run)(Case&, Recorder&);
};

/// All cases of a unit. Every driver library defines `umbral::driver`.
struct Driver {
    std::vector<DriverCase> cases;
    // Two constructors instead of an aggregate, so that a driver reads as a plain list of cases.
    Driver(std::initializer_list<DriverCase> list) : cases(list) {}
};

extern const Driver driver;

}
