#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

// What the fuzz targets share. A target is one function: whatever the bytes are, it returns. What it throws, what a
// sanitizer reports, what asks for more memory than the limit, and what hangs is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace umbral::tests {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

/// What must hold after bytes were read: a finding if not.
inline void expect(bool holds, const char* what)
{
    if (!holds) throw std::logic_error(what);
}

/// Does `read`, whose only complaint about bad bytes may be a `Refusal` of at most 16 KiB. Returns whether they were
/// good.
template <class Refusal, class Read>
bool reads(const Read& read)
{
    try {
        read();
    } catch (const Refusal& refusal) {
        expect(std::string_view(refusal.what()).size() <= 16384, "a complaint without end");
        return false;
    }
    return true;
}

}
