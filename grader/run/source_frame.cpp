#include "run/source_frame.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace umbral::grader {
namespace {

using Sizes = std::array<std::uint64_t, 2>;

[[noreturn]] void fail() { throw std::runtime_error("the frame of a unit's texts is not complete"); }

std::string_view take(std::string_view& bytes, std::uint64_t size)
{
    if (size > bytes.size()) fail();
    const std::string_view taken = bytes.substr(0, size);
    bytes.remove_prefix(size);
    return taken;
}

}

std::string framed(const std::map<std::string, std::string>& sources)
{
    std::string bytes;
    for (const auto& [name, text] : sources) {
        const Sizes sizes{name.size(), text.size()};
        bytes.append(reinterpret_cast<const char*>(sizes.data()), sizeof sizes);
        bytes += name;
        bytes += text;
    }
    return bytes;
}

std::map<std::string, std::string, std::less<>> unframed(std::string_view bytes)
{
    std::map<std::string, std::string, std::less<>> sources;
    while (!bytes.empty()) {
        Sizes sizes{};
        std::memcpy(sizes.data(), take(bytes, sizeof sizes).data(), sizeof sizes);
        const std::string_view name = take(bytes, sizes[0]);
        const std::string_view text = take(bytes, sizes[1]);
        if (!sources.emplace(name, text).second) fail();
    }
    return sources;
}

}
