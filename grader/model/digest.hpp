#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct evp_md_ctx_st;

namespace umbral::grader {

/// SHA-256 of bytes that arrive in pieces. Throws std::runtime_error if the cryptographic library fails.
class Sha256 {
public:
    Sha256();
    void update(std::span<const std::byte> bytes);
    void update(std::string_view text);
    /// Eight bytes, least significant first.
    void update(std::uint64_t number);
    /// Its length, then the text: fields added so cannot run into each other.
    void update_field(std::string_view text);
    /// 64 lower-case hexadecimal digits. Afterwards the hasher begins anew.
    [[nodiscard]] std::string finish();

private:
    void begin();

    struct Free {
        void operator()(evp_md_ctx_st* context) const noexcept;
    };
    std::unique_ptr<evp_md_ctx_st, Free> context_;
};

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256_hex(std::span<const std::byte> bytes);
[[nodiscard]] std::string sha256_hex(std::string_view text);

/// The same of a regular file's content. Throws std::runtime_error that names a file which cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& file);

/// 16 hexadecimal digits that tell secrets apart and say nothing of them: the first 64 bits of PBKDF2-HMAC-SHA256 (RFC
/// 8018) over the secret with a salt of this function's own and 200,000 rounds, so that guessing a poor secret by it
/// takes long. Takes about 0.1 s.
[[nodiscard]] std::string secret_fingerprint(std::string_view secret);

/// Seed of a hidden case: the first eight bytes (most significant first) of HMAC-SHA256 under `secret` over the tag
/// "umbral-case-seed-1", course, student, unit and case name, each behind its length in eight bytes (least significant
/// first), and the attempt in eight such bytes. Whoever lacks the secret cannot tell it from a random number. Based on:
/// H. Krawczyk, M. Bellare, R. Canetti. HMAC: Keyed-Hashing for Message Authentication. RFC 2104, 1997.
[[nodiscard]] std::uint64_t case_seed(std::string_view secret, std::string_view course, std::string_view student,
                                      std::string_view unit, std::string_view case_name, unsigned attempt);

}
