#pragma once

#include <elfutils/libdw.h>

namespace umbral::grader {

/// Calls `visit` for each compilation unit until it returns true. False if the debug information is damaged: what lies
/// behind the damage was not seen.
template <class Visit>
bool for_each_unit(Dwarf* dwarf, Visit visit)
{
    Dwarf_CU* unit = nullptr;
    Dwarf_Die die;
    int end = 0;
    while ((end = dwarf_get_units(dwarf, unit, &unit, nullptr, nullptr, &die, nullptr)) == 0)
        if (visit(&die)) return true;
    return end > 0;
}

}
