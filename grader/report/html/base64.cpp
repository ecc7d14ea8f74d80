#include "report/html/base64.hpp"

#include <openssl/evp.h>

#include <limits>
#include <stdexcept>

#include "model/digest.hpp"

namespace umbral::grader::html {

std::string base64(std::string_view bytes)
{
    if (bytes.size() > std::numeric_limits<int>::max() / 2)
        throw std::length_error("base64: expected less than 1 GiB, got more");
    std::string result((bytes.size() + 2) / 3 * 4 + 1, '\0');  // EVP_EncodeBlock ends it with a zero
    EVP_EncodeBlock(reinterpret_cast<unsigned char*>(result.data()),
                    reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
    result.pop_back();
    return result;
}

std::string source_hash(std::string_view text)
{
    const std::string hex = sha256_hex(text);
    std::string raw;
    for (std::size_t i = 0; i < hex.size(); i += 2) raw += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    return "sha256-" + base64(raw);
}

}
