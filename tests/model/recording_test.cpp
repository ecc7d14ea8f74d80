#include "model/recording.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "message_of.hpp"
#include "recording_bytes.hpp"

namespace umbral::grader {
namespace {

using Bytes = std::vector<std::byte>;

wire::Header header_of(const Bytes& bytes)
{
    wire::Header header{};
    std::memcpy(&header, bytes.data(), sizeof header);
    return header;
}

/// A finished run with a changed header.
Bytes with_header(const std::function<void(wire::Header&)>& change)
{
    Bytes bytes = test::finished_run();
    wire::Header header = header_of(bytes);
    change(header);
    std::memcpy(bytes.data(), &header, sizeof header);
    return bytes;
}

/// A finished run of one tensor, "t" of two floats and presence flags, whose header is changed.
Bytes with_tensor(const std::function<void(wire::TensorHeader&, std::byte* behind_header)>& change)
{
    Recorder recorder;
    recorder.append("t", std::optional<float>(1.5F));
    recorder.append("t", std::optional<float>());
    Bytes bytes = test::finished_run(recorder);
    wire::TensorHeader header{};
    std::byte* place = bytes.data() + wire::tensors_offset;
    std::memcpy(&header, place, sizeof header);
    change(header, place + sizeof header);
    std::memcpy(place, &header, sizeof header);
    return bytes;
}

TEST(Recording, of_vectors_that_may_be_absent_holds_a_row_for_each)
{
    Recorder recorder;
    recorder.append("places", std::optional(glm::vec3(1, 2, 3)));
    recorder.append("places", std::optional<glm::vec3>());
    recorder.append("pixels", std::optional<glm::ivec2>());
    recorder.append("pixels", std::optional(glm::ivec2(-7, 1 << 30)));
    const Recording recording = parse_recording(test::finished_run(recorder));
    const Tensor& places = recording.tensors.at("places");
    EXPECT_EQ(places.rows, 2U);
    EXPECT_EQ(places.components, 3U);
    EXPECT_EQ(places.present, (std::vector<std::uint8_t>{1, 0}));
    const Tensor& pixels = recording.tensors.at("pixels");
    EXPECT_EQ(pixels.element, Element::int32);
    EXPECT_EQ(pixels.present, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(pixels.bytes.size(), 4 * sizeof(std::int32_t));
    EXPECT_THROW(recorder.append("places", glm::vec2(0)), std::logic_error);
}

TEST(Recording, gives_back_what_was_recorded)
{
    const Recorder recorder = test::observations();
    const Recording recording = parse_recording(test::finished_run(recorder));
    EXPECT_EQ(recording.stage, wire::Stage::finished);
    EXPECT_EQ(recording.note, wire::Note::none);
    EXPECT_TRUE(recording.text.empty() && recording.refused.empty() && recording.frames.empty());
    EXPECT_EQ(recording.tensors, recorder.tensors());
    // By hand, since writer and reader could agree on something wrong.
    const Tensor& t = recording.tensors.at("t");
    EXPECT_EQ(t.present, (std::vector<std::uint8_t>{1, 0, 1, 0, 1}));
    float third = 0;
    std::memcpy(&third, t.bytes.data() + 8, sizeof third);
    EXPECT_EQ(third, 1.0F);
    EXPECT_EQ(recording.tensors.at("größe").rows, 2U);
    EXPECT_EQ(recording.tensors.at("größe").columns, 3U);
}

TEST(Recording, reads_at_any_alignment)
{
    const Bytes bytes = test::finished_run();
    Bytes shifted(bytes.size() + 1);
    std::memcpy(shifted.data() + 1, bytes.data(), bytes.size());
    EXPECT_EQ(parse_recording(std::span(shifted).subspan(1)).tensors.size(), 6U);
}

TEST(Recording, tells_of_a_crash_and_ignores_tensors_of_a_run_that_did_not_finish)
{
    const Recording recording = parse_recording(with_header([](wire::Header& header) {
        header.stage = static_cast<std::uint32_t>(wire::Stage::running);
        header.note = static_cast<std::uint32_t>(wire::Note::signal);
        header.signal = 11;
        header.not_implemented = 3;
        header.refused_count = 40;
        header.refused[0] = 41;
        header.refused[31] = 57;
        header.frame_count = 2;
        header.frames[0] = 0x1234;
        header.tensors_size = ~std::uint64_t{0};
        std::memcpy(header.text, "bad \x1b[m", 8);
    }));
    EXPECT_EQ(recording.stage, wire::Stage::running);
    EXPECT_EQ(recording.note, wire::Note::signal);
    EXPECT_EQ(recording.signal, 11U);
    EXPECT_EQ(recording.not_implemented, 3U);
    EXPECT_EQ(recording.refused_count, 40U);
    ASSERT_EQ(recording.refused.size(), 32U);
    EXPECT_EQ(recording.refused.front(), 41U);
    EXPECT_EQ(recording.refused.back(), 57U);
    EXPECT_EQ(recording.frames, (std::vector<std::uint64_t>{0x1234, 0}));
    EXPECT_EQ(recording.text, "bad \uFFFD[m");
    EXPECT_TRUE(recording.tensors.empty());
}

TEST(Recording, refuses_sizes_that_no_run_leaves)
{
    EXPECT_THROW((void)parse_recording({}), DamagedRecording);
    const Bytes bytes = test::finished_run();
    for (const std::size_t size : {std::size_t{1}, sizeof(wire::Header), wire::tensors_offset - 1, wire::tensors_offset,
                                   wire::tensors_offset + 8})
        EXPECT_THROW((void)parse_recording(std::span(bytes).first(size)), DamagedRecording) << size;
    EXPECT_THROW((void)parse_recording(Bytes(wire::tensors_offset)), DamagedRecording) << "all zero";
    Bytes large = bytes;
    large.resize(wire::maximum_size);
    EXPECT_NO_THROW((void)parse_recording(large));
    large.resize(wire::maximum_size + 1);
    EXPECT_THROW((void)parse_recording(large), DamagedRecording);
}

struct WrongHeader {
    const char* message;
    void (*change)(wire::Header&);
};
class DamagedHeader : public testing::TestWithParam<WrongHeader> {};

TEST_P(DamagedHeader, is_refused_with_the_reason)
{
    const Bytes bytes = with_header(GetParam().change);
    EXPECT_THROW((void)parse_recording(bytes), DamagedRecording);
    const std::string message = test::message_of([&] { (void)parse_recording(bytes); });
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Recording, DamagedHeader,
    testing::Values(WrongHeader{"UMBRAL01", [](wire::Header& h) { ++h.magic; }},
                    WrongHeader{"expected a stage from 0 to 4, got 5", [](wire::Header& h) { h.stage = 5; }},
                    WrongHeader{"a note", [](wire::Header& h) { h.note = 9; }},
                    WrongHeader{"a signal", [](wire::Header& h) { h.signal = 65; }},
                    WrongHeader{"at most 32 frames", [](wire::Header& h) { h.frame_count = 33; }},
                    WrongHeader{"a zero behind the text",
                                [](wire::Header& h) { std::memset(h.text, 'x', sizeof h.text); }},
                    WrongHeader{"a size within the file", [](wire::Header& h) { h.tensors_size = 4097; }},
                    WrongHeader{"a size within the file", [](wire::Header& h) { h.tensors_size = ~std::uint64_t{0}; }},
                    WrongHeader{"at most 256 tensors", [](wire::Header& h) { h.tensor_count = ~std::uint64_t{0}; }},
                    WrongHeader{"the header of a tensor", [](wire::Header& h) { ++h.tensor_count; }},
                    WrongHeader{"no bytes behind the last tensor", [](wire::Header& h) { --h.tensor_count; }},
                    WrongHeader{"no bytes behind the last tensor", [](wire::Header& h) { h.tensors_size += 8; }},
                    WrongHeader{"the presence flags of a tensor", [](wire::Header& h) { h.tensors_size -= 8; }}));

struct WrongTensor {
    const char* message;
    void (*change)(wire::TensorHeader&, std::byte*);
};
class DamagedTensor : public testing::TestWithParam<WrongTensor> {};

TEST_P(DamagedTensor, is_refused_with_the_reason)
{
    const Bytes bytes = with_tensor(GetParam().change);
    EXPECT_THROW((void)parse_recording(bytes), DamagedRecording);
    const std::string message = test::message_of([&] { (void)parse_recording(bytes); });
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}

// Behind the tensor's header: 8 bytes of name, 8 of values, 8 of flags.
INSTANTIATE_TEST_SUITE_P(
    Recording, DamagedTensor,
    testing::Values(
        WrongTensor{"an element type", [](wire::TensorHeader& h, std::byte*) { h.element = 0; }},
        WrongTensor{"an element type", [](wire::TensorHeader& h, std::byte*) { h.element = 6; }},
        WrongTensor{"a number of rows", [](wire::TensorHeader& h, std::byte*) { h.rows = ~0U; }},
        WrongTensor{"a number of columns", [](wire::TensorHeader& h, std::byte*) { h.columns = ~0U; }},
        WrongTensor{"a number of cells", [](wire::TensorHeader& h, std::byte*) { h.rows = h.columns = 1U << 26U; }},
        WrongTensor{"1 to 1024 components", [](wire::TensorHeader& h, std::byte*) { h.components = 0; }},
        WrongTensor{"1 to 1024 components", [](wire::TensorHeader& h, std::byte*) { h.components = 1U << 31U; }},
        WrongTensor{"the values of a tensor", [](wire::TensorHeader& h, std::byte*) { h.rows = 1U << 26U; }},
        WrongTensor{"the values of a tensor", [](wire::TensorHeader& h, std::byte*) { h.components = 1024; }},
        WrongTensor{"a name of 1 to 64 bytes", [](wire::TensorHeader& h, std::byte*) { h.name_size = 0; }},
        WrongTensor{"a name of 1 to 64 bytes", [](wire::TensorHeader& h, std::byte*) { h.name_size = ~0U; }},
        WrongTensor{"a printable name", [](wire::TensorHeader&, std::byte* name) { *name = std::byte{0x1B}; }},
        WrongTensor{"a printable name", [](wire::TensorHeader&, std::byte* name) { *name = std::byte{0xFF}; }},
        WrongTensor{"flag 0", [](wire::TensorHeader& h, std::byte*) { h.has_present = 2; }},
        WrongTensor{"flag 0", [](wire::TensorHeader& h, std::byte*) { h.rows = 0; }},
        WrongTensor{"no bytes behind", [](wire::TensorHeader& h, std::byte*) { h.has_present = 0; }},
        WrongTensor{"presence flags of 0 or 1", [](wire::TensorHeader&, std::byte* name) { name[16] = std::byte{2}; }},
        WrongTensor{"bytes 0 where there is no value",
                    [](wire::TensorHeader&, std::byte* name) { name[12] = std::byte{1}; }}));

TEST(Recording, refuses_one_name_twice)
{
    Recorder recorder;
    recorder.append("a", 1.0F);
    recorder.append("b", 2.0F);
    Bytes bytes = test::finished_run(recorder);
    EXPECT_EQ(parse_recording(bytes).tensors.size(), 2U);
    bytes[wire::tensors_offset + 24 + 16 + 24] = std::byte{'a'};
    EXPECT_NE(test::message_of([&] { (void)parse_recording(bytes); }).find("a name not used before, got 'a'"),
              std::string::npos);
}

}
}
