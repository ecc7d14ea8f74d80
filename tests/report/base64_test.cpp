#include "report/html/base64.hpp"

#include <gtest/gtest.h>

namespace umbral::grader::html {
namespace {

TEST(Base64, known_answers)
{
    // The test vectors of RFC 4648.
    for (const auto& [bytes, text] : {std::pair{"", ""},
                                      {"f", "Zg=="},
                                      {"fo", "Zm8="},
                                      {"foo", "Zm9v"},
                                      {"foob", "Zm9vYg=="},
                                      {"fooba", "Zm9vYmE="},
                                      {"foobar", "Zm9vYmFy"}})
        EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(base64(std::string("\xFF\x00\xFE", 3)), "/wD+");
    EXPECT_EQ(source_hash(""), "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=") << "of the empty text";
}

}
}
