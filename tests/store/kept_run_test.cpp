#include "store/kept_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

using umbral::test::TemporaryFolder;

KeptRun run()
{
    KeptRun run;
    run.times = {0.1, 0.25};
    Tensor picture{Element::uint8, 2, 3, 4, std::vector<std::byte>(24, std::byte{7}), {}};
    Tensor numbers{Element::float64, 2, 1, 1, std::vector<std::byte>(16, std::byte{0xFF}), {1, 0}};
    std::fill(numbers.bytes.begin() + 8, numbers.bytes.end(), std::byte{0});  // of the cell that has no value
    run.tensors = {{"none", {Element::int32, 0, 3, 1, {}, {}}}, {"picture", picture}, {"t.margin", numbers}};
    return run;
}

TEST(KeptRun, comes_back_bit_for_bit)
{
    const TemporaryFolder folder;
    keep_run(folder / "run", run());
    const auto kept = kept_run(folder / "run");
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->tensors, run().tensors);
    EXPECT_EQ(kept->times.cpu_seconds, 0.1);
    EXPECT_EQ(kept->times.wall_seconds, 0.25);
    keep_run(folder / "run", {});
    EXPECT_TRUE(kept_run(folder / "run")->tensors.empty());
}

TEST(KeptRun, is_nothing_if_missing_or_damaged_anywhere)
{
    const TemporaryFolder folder;
    EXPECT_FALSE(kept_run(folder / "missing"));
    EXPECT_FALSE(kept_run(folder.path()));
    keep_run(folder / "run", run());
    const std::string text = umbral::test::read(folder / "run");
    // Each byte of both ends, where all that is not padding lies, and some between.
    constexpr std::size_t end = 400;
    for (std::size_t i = 0; i < text.size(); i += i < end || i + end > text.size() ? 1 : 509) {
        std::string other = text;
        other[i] = static_cast<char>(other[i] ^ 1);
        folder.write("other", other);
        EXPECT_FALSE(kept_run(folder / "other")) << "byte " << i;
        folder.write("other", text.substr(0, i));
        EXPECT_FALSE(kept_run(folder / "other")) << "cut before byte " << i;
    }
    folder.write("other", text + "x");
    EXPECT_FALSE(kept_run(folder / "other"));
}

}
}
