#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

// The same scene by the engine over the rasteriser's reference, and over its oracle, which computes in 128 bits.
namespace umbral::test {
namespace {

template <class Number>
std::vector<Number> numbers_in(const std::filesystem::path& npy)
{
    const std::string bytes = read(npy);
    const std::size_t begin =
        10 + static_cast<unsigned char>(bytes.at(8)) + 256U * static_cast<unsigned char>(bytes.at(9));
    std::vector<Number> numbers((bytes.size() - begin) / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data() + begin, numbers.size() * sizeof(Number));
    return numbers;
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b)
{
    EXPECT_EQ(a.size(), b.size());
    double largest = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::abs(double{a[i]} - double{b[i]}));
    return largest;
}

TEST(RenderOracle, agrees_in_every_id_and_within_one_ulp_in_every_depth)
{
    for (const std::string size : {"64x64", "320x240"}) {
        const TemporaryFolder folder;
        const std::string options =
            " " UMBRAL_SOURCE_DIR "/reference/scenes/first-light.json --size " + size + " --buffers ";
        ASSERT_EQ(umbral(options + (folder / "reference").string()).status, 0);
        ASSERT_EQ(std::system((UMBRAL_ORACLE + options + (folder / "oracle").string()).c_str()), 0);
        const auto ids = numbers_in<std::uint32_t>(folder / "reference/ids.npy");
        EXPECT_EQ(ids, numbers_in<std::uint32_t>(folder / "oracle/ids.npy"));
        EXPECT_GT(ids.size(), 4000U);
        const auto depth = [&](const char* who) { return numbers_in<float>(folder / who / "depth.npy"); };
        const auto color = [&](const char* who) { return numbers_in<float>(folder / who / "color.npy"); };
        EXPECT_LE(largest_difference(depth("reference"), depth("oracle")), 0x1p-24);
        // A weight's last bit moves a texture coordinate by 2^-23, over texels of contrast 1 that are 1/3072 wide.
        EXPECT_LE(largest_difference(color("reference"), color("oracle")), 1e-3);
    }
}

}
}
