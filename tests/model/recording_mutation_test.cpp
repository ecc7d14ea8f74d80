#include <gtest/gtest.h>

#include <array>
#include <random>

#include "model/recording.hpp"
#include "recording_bytes.hpp"
#include "text/printable.hpp"

namespace umbral::grader {
namespace {

constexpr int rounds = 200'000;

/// Overwrites random places of a recording as a wild or a hostile program would: single bits, bytes, and numbers that
/// make sums wrap.
class Vandal {
public:
    explicit Vandal(unsigned seed) : random_(seed) {}

    void strike(std::span<std::byte> bytes)
    {
        const auto strikes = 1 + random_() % 4;
        for (unsigned i = 0; i < strikes; ++i) {
            switch (random_() % 3) {
                case 0: bytes[place(bytes)] ^= std::byte{static_cast<unsigned char>(1U << random_() % 8)}; break;
                case 1: bytes[place(bytes)] = static_cast<std::byte>(random_()); break;
                default: overwrite_number(bytes); break;
            }
        }
    }

private:
    /// Mostly where lengths and shapes stand: in the fixed part of the header, or among the tensors.
    std::size_t place(std::span<const std::byte> bytes)
    {
        constexpr std::size_t fixed = offsetof(wire::Header, text);
        if (random_() % 4 == 0) return random_() % fixed;
        if (random_() % 16 == 0) return random_() % bytes.size();
        return wire::tensors_offset + random_() % (bytes.size() - wire::tensors_offset);
    }

    void overwrite_number(std::span<std::byte> bytes)
    {
        constexpr std::array<std::uint64_t, 10> numbers{
            0, 1, 7, 64, 255, 1U << 26U, 0x7FFFFFFF, 0xFFFFFFFF, 0x7FFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF};
        const std::uint64_t number = numbers[random_() % numbers.size()];
        const std::size_t size = random_() % 2 == 0 ? 4 : 8;
        const std::size_t at = std::min(place(bytes) / 4 * 4, bytes.size() - size);
        std::memcpy(bytes.data() + at, &number, size);
    }

    std::mt19937 random_;
};

/// What every recording that is let through must hold.
void expect_sound(const Recording& recording, std::size_t size)
{
    std::size_t total = recording.text.size() / 3;
    for (const auto& [name, tensor] : recording.tensors) {
        ASSERT_EQ(tensor.bytes.size(), tensor.count() * size_of(tensor.element));
        ASSERT_TRUE(tensor.present.empty() || tensor.present.size() == tensor.cells());
        ASSERT_EQ(printable(name, wire::maximum_name), name);
        total += name.size() + tensor.bytes.size() + tensor.present.size();
    }
    ASSERT_LE(total, size);
    ASSERT_LE(recording.refused.size(), 32U);
    ASSERT_LE(recording.frames.size(), 32U);
    ASSERT_EQ(printable(recording.text, recording.text.size()), recording.text);
}

TEST(RecordingMutation, parses_or_is_refused_whatever_bytes_are_overwritten)
{
    const unsigned seed = std::random_device{}();
    std::printf("seed %u\n", seed);
    Vandal vandal(seed);
    // Exactly as long as what is used, so that a read behind the end is one behind the allocation, where the sanitizer
    // sees it.
    std::vector<std::byte> original = test::finished_run();
    wire::Header header{};
    std::memcpy(&header, original.data(), sizeof header);
    original.resize(wire::tensors_offset + header.tensors_size);
    original.shrink_to_fit();
    int parsed = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
        std::vector<std::byte> bytes = original;
        vandal.strike(bytes);
        if (round % 8 == 0) bytes.resize(bytes.size() - static_cast<std::size_t>(round / 8) % 600);
        try {
            expect_sound(parse_recording(bytes), bytes.size());
            ++parsed;
        } catch (const DamagedRecording&) {
            // The other right end; any other exception fails the test.
        }
        if (HasFatalFailure()) return;
    }
    std::printf("%d of %d were parsed, the others refused\n", parsed, rounds);
    // Both ends must be reached, or the mutations test nothing.
    EXPECT_GT(parsed, rounds / 100);
    EXPECT_LT(parsed, rounds - rounds / 100);
}

}
}
