#include <cstddef>
#include <cstdint>

#include "ply_property.hpp"

// For libFuzzer, see README.md. What is thrown, or asks for more memory than the limit, or hangs, is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    (void)umbral::tests::holds_for({reinterpret_cast<const char*>(data), size});
    return 0;
}
