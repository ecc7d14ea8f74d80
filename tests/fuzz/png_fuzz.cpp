#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <umbral/core/png.hpp>

#include "fuzz.hpp"

#ifdef UMBRAL_FUZZ
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maximum);
#endif

namespace {

using namespace umbral;

constexpr std::size_t signature = 8;

std::uint32_t big_endian(const std::uint8_t* at)
{
    return std::uint32_t{at[0]} << 24U | std::uint32_t{at[1]} << 16U | std::uint32_t{at[2]} << 8U |
           std::uint32_t{at[3]};
}

/// A file in memory, since pictures are read by path.
class MemoryFile {
public:
    MemoryFile(const std::uint8_t* data, std::size_t size) : number_(memfd_create("fuzz", MFD_CLOEXEC))
    {
        tests::expect(number_ >= 0 && write(number_, data, size) == static_cast<ssize_t>(size), "no memory file");
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { close(number_); }
    [[nodiscard]] std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(number_); }

private:
    int number_;
};

/// Does the header promise more pixels than can be tried many times a second? The limit itself has a test of its own.
bool promises_much(const std::uint8_t* data, std::size_t size)
{
    constexpr std::size_t width = signature + 8;
    return size >= width + 8 &&
           std::uint64_t{big_endian(data + width)} * big_endian(data + width + 4) > (std::uint64_t{1} << 20U) &&
           std::uint64_t{big_endian(data + width)} * big_endian(data + width + 4) <= maximum_png_pixels;
}

}

#ifdef UMBRAL_FUZZ
namespace {

/// The sum behind a chunk: CRC-32 as PNG's specification has it, annex D.
std::uint32_t sum_of(const std::uint8_t* bytes, std::size_t size)
{
    std::uint32_t sum = 0xFFFFFFFFU;
    for (std::size_t i = 0; i < size; ++i) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? 0xEDB88320U ^ (sum >> 1U) : sum >> 1U;
    }
    return ~sum;
}

}

// Chunks whose sums do not hold are refused at once: the sums are put right after each mutation, or nothing behind them
// is ever tried.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maximum, unsigned seed)
{
    size = LLVMFuzzerMutate(data, size, maximum);
    if (seed % 8 == 0) return size;
    for (std::size_t at = signature; at + 12 <= size;) {
        const std::size_t length = big_endian(data + at);
        if (length > size - at - 12) break;
        const std::uint32_t sum = sum_of(data + at + 4, length + 4);
        for (unsigned i = 0; i < 4; ++i) data[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += 12 + length;
    }
    return size;
}
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (promises_much(data, size)) return 0;
    const MemoryFile file(data, size);
    (void)tests::reads<std::runtime_error>([&] {
        const Image image = read_png(file.path());
        tests::expect(image.width > 0 && image.height > 0, "a picture without pixels");
        tests::expect(
            image.cells.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
            "pixels that are not as many as the size says");
        tests::expect(image.cells.size() <= maximum_png_pixels, "a picture larger than the limit");
    });
    return 0;
}
