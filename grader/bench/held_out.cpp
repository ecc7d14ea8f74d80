#include "bench/held_out.hpp"

#include <cstdint>

namespace umbral::grader {

bool held_out(const std::string& name)
{
    // FNV-1a, folded: the low bit alone follows the letters' low bits.
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : name.substr(0, name.find(':')))
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return ((hash ^ (hash >> 17U) ^ (hash >> 41U)) & 1U) != 0;
}

}
