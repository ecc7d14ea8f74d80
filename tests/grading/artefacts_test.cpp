#include "unit/artefacts.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "support/temporary_folder.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

const std::string question = "a question";
const auto bytes = std::as_bytes(std::span(question));

// A workspace that was sent may hold files with the names of artefacts.
TEST(Artefacts, take_the_place_of_planted_files)
{
    const umbral::test::TemporaryFolder folder;
    const fs::path precious = folder.path() / "precious";
    std::ofstream(precious) << "precious";
    const fs::path artefacts = folder.path() / "umbral-pictures";
    fs::create_directory(artefacts);
    fs::create_symlink(precious, artefacts / "link.txt");
    fs::create_hard_link(precious, artefacts / "hard.txt");
    fs::create_symlink("/dev/null", artefacts / "device.txt");
    fs::create_symlink(folder.path(), artefacts / "folder.txt");
    ASSERT_EQ(mkfifo((artefacts / "pipe.txt").c_str(), S_IRUSR | S_IWUSR), 0);
    for (const char* const name : {"link.txt", "hard.txt", "device.txt", "folder.txt", "pipe.txt", "new.txt"}) {
        write_artefact(artefacts / name, bytes);
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(artefacts / name))) << name;
        EXPECT_EQ(content_of(artefacts / name), question) << name;
    }
    EXPECT_EQ(content_of(precious), "precious");
}

TEST(Artefacts, are_not_written_where_a_link_leads)
{
    const umbral::test::TemporaryFolder folder;
    const fs::path elsewhere = folder.path() / "elsewhere";
    fs::create_directory(elsewhere);
    fs::create_directory_symlink(elsewhere, folder.path() / "umbral-pictures");
    EXPECT_THROW(make_artefact_folder(folder.path() / "umbral-pictures"), std::runtime_error);
    EXPECT_THROW(write_artefact(folder.path() / "umbral-pictures" / "x.txt", bytes), std::runtime_error);
    EXPECT_TRUE(fs::is_empty(elsewhere));
}

}
}
