#pragma once

#include <cstdint>

namespace umbral::grader {

/// What memory holds that `new` has just given, or `delete` just taken back.
enum class FreshMemory : std::uint8_t {
    as_it_comes,
    nonsense,          ///< bytes 0xFE, as variables in students' libraries: -1.7e38, no pointer, the code of no element
    lasting_nonsense,  ///< small blocks that were given back keep it for a while: they are not given out again
    lasting_zeros
};

/// From now on all memory that operator new and delete deal with in this process is filled so, at most its first MiB:
/// code that reads what it never wrote, or what it has given back, is not right by chance. The spawners' own operators
/// do it, which all libraries that they load use too; malloc itself stays as it is, and writes addresses into the first
/// bytes of what it takes back.
void fill_fresh_memory(FreshMemory with) noexcept;

}
