#include "model/digest.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace umbral::grader {
namespace {

std::array<unsigned char, 8> little_endian(std::uint64_t number)
{
    std::array<unsigned char, 8> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(number >> (8 * i));
    return bytes;
}

void check(int result, const char* what)
{
    if (result != 1)
        throw std::runtime_error(
            fmt::format("SHA-256: {} failed in the OpenSSL library; check its installation", what));
}

/// Calls `use` with the pieces of a file.
template <class Use>
void read_in_pieces(const std::filesystem::path& file, Use&& use)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !std::filesystem::is_regular_file(file))
        throw std::runtime_error(fmt::format("{}: expected a readable regular file", file.string()));
    std::array<char, 65536> piece{};
    while (stream.read(piece.data(), piece.size()), stream.gcount() > 0)
        use(std::string_view(piece.data(), static_cast<std::size_t>(stream.gcount())));
    if (stream.bad()) throw std::runtime_error(fmt::format("{}: reading failed half way", file.string()));
}

}

void Sha256::Free::operator()(evp_md_ctx_st* context) const noexcept { EVP_MD_CTX_free(context); }

Sha256::Sha256() : context_(EVP_MD_CTX_new())
{
    check(context_ != nullptr ? 1 : 0, "EVP_MD_CTX_new");
    begin();
}

void Sha256::begin() { check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr), "EVP_DigestInit_ex"); }

void Sha256::update(std::span<const std::byte> bytes)
{
    check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()), "EVP_DigestUpdate");
}

void Sha256::update(std::string_view text) { update(std::as_bytes(std::span(text))); }

void Sha256::update(std::uint64_t number)
{
    const auto bytes = little_endian(number);
    update(std::as_bytes(std::span(bytes)));
}

void Sha256::update_field(std::string_view text)
{
    update(std::uint64_t{text.size()});
    update(text);
}

std::string Sha256::finish()
{
    std::array<unsigned char, 32> digest{};
    check(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr), "EVP_DigestFinal_ex");
    begin();
    std::string text;
    for (const unsigned char byte : digest) text += fmt::format("{:02x}", byte);
    return text;
}

std::string sha256_hex(std::span<const std::byte> bytes)
{
    Sha256 hash;
    hash.update(bytes);
    return hash.finish();
}

std::string sha256_hex(std::string_view text) { return sha256_hex(std::as_bytes(std::span(text))); }

std::string sha256_of_file(const std::filesystem::path& file)
{
    Sha256 hash;
    read_in_pieces(file, [&](std::string_view piece) { hash.update(piece); });
    return hash.finish();
}

std::string secret_fingerprint(std::string_view secret)
{
    constexpr std::string_view salt = "umbral-secret-fingerprint-1";
    constexpr int rounds = 200000;
    std::array<unsigned char, 8> code{};
    check(PKCS5_PBKDF2_HMAC(secret.data(), static_cast<int>(secret.size()),
                            reinterpret_cast<const unsigned char*>(salt.data()), static_cast<int>(salt.size()), rounds,
                            EVP_sha256(), static_cast<int>(code.size()), code.data()),
          "PKCS5_PBKDF2_HMAC");
    std::string text;
    for (const unsigned char byte : code) text += fmt::format("{:02x}", byte);
    return text;
}

std::uint64_t case_seed(std::string_view secret, std::string_view course, std::string_view student,
                        std::string_view unit, std::string_view case_name, unsigned attempt)
{
    std::vector<unsigned char> message;
    const auto add = [&](const auto& bytes) { message.insert(message.end(), bytes.begin(), bytes.end()); };
    for (const std::string_view field : {std::string_view("umbral-case-seed-1"), course, student, unit, case_name}) {
        add(little_endian(field.size()));
        add(field);
    }
    add(little_endian(attempt));

    // OpenSSL takes a null key for "the key of last time": an empty secret still needs an address.
    const std::string key(secret);
    std::array<unsigned char, 32> code{};
    unsigned size = 0;
    check(HMAC(EVP_sha256(), key.c_str(), static_cast<int>(key.size()), message.data(), message.size(), code.data(),
               &size) != nullptr
              ? 1
              : 0,
          "HMAC");
    std::uint64_t seed = 0;
    for (std::size_t i = 0; i < 8; ++i) seed = seed << 8U | code[i];
    return seed;
}

}
