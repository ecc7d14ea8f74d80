#include "fuzz.hpp"
#include "ply_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    (void)umbral::tests::holds_for(umbral::tests::text_of(data, size));
    return 0;
}
