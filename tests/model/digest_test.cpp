#include "model/digest.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

TEST(Sha256, gives_the_published_values)
{
    // FIPS 180-2, appendix B, and the digest of nothing.
    EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, does_not_care_how_bytes_arrive_and_begins_anew)
{
    Sha256 hash;
    for (const char letter : std::string_view("abc")) hash.update(std::string_view(&letter, 1));
    EXPECT_EQ(hash.finish(), sha256_hex("abc"));
    EXPECT_EQ(hash.finish(), sha256_hex(""));
    hash.update(std::uint64_t{0x6362'61});
    EXPECT_EQ(hash.finish(), sha256_hex(std::string_view("abc\0\0\0\0\0", 8)));
}

// The expected values below come from Python's hashlib and hmac.
TEST(Sha256, reads_files_longer_than_one_piece)
{
    const umbral::test::TemporaryFolder folder;
    folder.write("zeros", std::string(1000003, '\0'));
    EXPECT_EQ(sha256_of_file(folder.path() / "zeros"),
              "9e3c25400146ab5a01345705a1916a2e76a43c45789e38e14420f4eb47d5e384");
    EXPECT_THROW((void)sha256_of_file(folder.path() / "none"), std::runtime_error);
    EXPECT_THROW((void)sha256_of_file(folder.path()), std::runtime_error);
}

TEST(CaseSeed, is_the_keyed_hash_of_its_fields)
{
    EXPECT_EQ(case_seed("secret", "cg-2024", "Zoë", "raytracing/sphere", "far away", 3), 10924279257747322335U);
    EXPECT_EQ(case_seed("", "", "", "", "", 0), 299863444582512010U);
    EXPECT_EQ(case_seed({}, {}, {}, {}, {}, 0), 299863444582512010U);
}

TEST(CaseSeed, differs_in_every_field_and_where_fields_meet)
{
    const std::set<std::uint64_t> seeds{case_seed("k", "ab", "c", "d", "e", 1), case_seed("k", "a", "bc", "d", "e", 1),
                                        case_seed("k", "ab", "c", "de", "", 1), case_seed("k", "ab", "c", "", "de", 1),
                                        case_seed("k", "ab", "c", "d", "e", 2), case_seed("j", "ab", "c", "d", "e", 1),
                                        case_seed("k", "ab", "C", "d", "e", 1), case_seed("k", "ab", "c", "d", "e1", 1),
                                        case_seed("ka", "b", "c", "d", "e", 1)};
    EXPECT_EQ(seeds.size(), 9U);
}

}
}
