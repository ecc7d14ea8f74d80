#include "store/kept_unit.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <random>

#include "../model/results.hpp"
#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

using umbral::test::TemporaryFolder;

KeptUnit kept() { return {std::string(64, 'k'), "machine", test::submission().units[0]}; }

const UnitSections sections{"<section>a\nb\x01</section>\n", "<section>more</section>"};

TEST(KeptUnit, comes_back_with_its_sections)
{
    const TemporaryFolder folder;
    const auto file = folder / "one.unit";
    keep_unit(file, kept(), sections);
    const auto unit = kept_unit(file);
    ASSERT_TRUE(unit);
    EXPECT_EQ(unit->key, kept().key);
    EXPECT_EQ(unit->machine, "machine");
    EXPECT_EQ(to_json(unit->result), to_json(kept().result));
    const auto texts = kept_sections(file);
    ASSERT_TRUE(texts);
    EXPECT_EQ(texts->student, sections.student);
    EXPECT_EQ(texts->instructor, sections.instructor);
    keep_unit(file, kept(), {"", ""});
    EXPECT_EQ(kept_sections(file)->student, "");
    EXPECT_EQ(folder.count(), 1) << "no temporary file is left";
    EXPECT_FALSE(kept_unit(folder / "none.unit"));
    EXPECT_FALSE(kept_sections(folder / "none.unit"));
}

// Opening it would wait for somebody who writes.
TEST(KeptUnit, a_pipe_is_not_there)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "sphere.unit").c_str(), 0600), 0);
    EXPECT_FALSE(kept_unit(folder / "sphere.unit"));
    EXPECT_FALSE(kept_sections(folder / "sphere.unit"));
}

TEST(KeptUnit, damaged_files_are_not_there)
{
    const TemporaryFolder folder;
    const auto file = folder / "one.unit";
    keep_unit(file, kept(), sections);
    const std::string whole = umbral::test::read(file);
    const std::string expected = to_json(kept().result).dump();
    for (std::size_t size = 0; size < whole.size(); size += 1 + size / 16) {
        folder.write("one.unit", whole.substr(0, size));
        EXPECT_FALSE(kept_unit(file)) << size << " of " << whole.size() << " bytes";
    }
    folder.write("one.unit", whole + "x");
    EXPECT_FALSE(kept_unit(file));
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 300; ++round) {
        std::string damaged = whole;
        damaged[random() % damaged.size()] = static_cast<char>(random());
        folder.write("one.unit", damaged);
        (void)kept_unit(file);  // must not crash or throw
        if (const auto texts = kept_sections(file)) {
            EXPECT_EQ(texts->student + texts->instructor, sections.student + sections.instructor)
                << "no damaged section gets into a report";
        }
    }
}

}
}
