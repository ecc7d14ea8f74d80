#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <umbral/pipeline/layout.hpp>

using namespace umbral::pipeline;

namespace {

using enum ComponentType;

const std::vector<VertexAttribute> course = {{float32, 3}, {float32, 3}, {float32, 3}, {float32, 2}};

std::vector<std::uint64_t> offsets(const VertexLayout& layout)
{
    std::vector<std::uint64_t> result;
    for (const AttributePlace& place : layout.places) result.push_back(place.offset);
    return result;
}

}

TEST(VertexLayout, worked_number_of_the_statement)
{
    const VertexLayout interleaved = interleaved_layout(course, 8);
    EXPECT_EQ(offsets(interleaved), (std::vector<std::uint64_t>{0, 12, 24, 36}));
    for (const AttributePlace& place : interleaved.places) EXPECT_EQ(place.stride, 44U);
    const VertexLayout separate = separate_layout(course, 8);
    EXPECT_EQ(offsets(separate), (std::vector<std::uint64_t>{0, 96, 192, 288}));
    EXPECT_EQ(separate.places.back().stride, 8U);
    EXPECT_EQ(interleaved.bytes, 352U);
    EXPECT_EQ(separate.bytes, 352U);
}

// The compiler is the independent opinion.
TEST(VertexLayout, interleaved_is_what_the_compiler_makes_of_a_struct)
{
    struct A {
        double position[3];
        std::uint8_t color[4];
        float normal[3];
    };
    const std::vector<VertexAttribute> a = {{float64, 3}, {unsigned_byte, 4}, {float32, 3}};
    EXPECT_EQ(offsets(interleaved_layout(a, 1)),
              (std::vector<std::uint64_t>{offsetof(A, position), offsetof(A, color), offsetof(A, normal)}));
    EXPECT_EQ(interleaved_layout(a, 7).bytes, sizeof(A[7]));
    struct B {
        float position[3];
        std::uint8_t material;
        std::uint16_t texture[2];
    };
    const std::vector<VertexAttribute> b = {{float32, 3}, {unsigned_byte, 1}, {unsigned_short, 2}};
    EXPECT_EQ(offsets(interleaved_layout(b, 1)),
              (std::vector<std::uint64_t>{offsetof(B, position), offsetof(B, material), offsetof(B, texture)}));
    EXPECT_EQ(interleaved_layout(b, 7).bytes, sizeof(B[7]));
    struct C {
        std::uint8_t flags[3];
        double position[2];
        std::uint8_t last;
    };
    const std::vector<VertexAttribute> c = {{unsigned_byte, 3}, {float64, 2}, {unsigned_byte, 1}};
    EXPECT_EQ(offsets(interleaved_layout(c, 1)),
              (std::vector<std::uint64_t>{offsetof(C, flags), offsetof(C, position), offsetof(C, last)}));
    EXPECT_EQ(interleaved_layout(c, 7).bytes, sizeof(C[7]));
}

TEST(VertexLayout, more_than_four_gibibytes)
{
    EXPECT_EQ(interleaved_layout(course, 4'000'000'000).bytes, 176'000'000'000U);
    EXPECT_EQ(separate_layout(course, 4'000'000'000).places.back().offset, 144'000'000'000U);
}

TEST(VertexLayout, there_and_back_again)
{
    const std::vector<VertexAttribute> attributes = {{unsigned_byte, 3}, {float64, 2}, {unsigned_short, 1}};
    const VertexLayout tight{{{0, 0}, {15, 0}, {95, 0}}, 105};  // five vertices, strides of 0, no gaps
    std::vector<std::byte> source(105);
    for (std::size_t i = 0; i < source.size(); ++i) source[i] = static_cast<std::byte>(i + 1);
    const VertexLayout interleaved = interleaved_layout(attributes, 5);
    const std::vector<std::byte> there = repack(source, tight, interleaved, attributes, 5);
    ASSERT_EQ(there.size(), 5U * 32);
    EXPECT_EQ(there[3], std::byte{0}) << "a gap";
    EXPECT_EQ(there[32], std::byte{4}) << "the second vertex begins with its bytes";
    EXPECT_EQ(repack(there, interleaved, tight, attributes, 5), source);
}

TEST(VertexLayout, fetched_as_open_gl_does)
{
    std::vector<std::byte> buffer(40);
    const double reals[] = {0.1, -2.5};
    std::memcpy(buffer.data() + 3, reals, sizeof reals);  // not a multiple of anything
    EXPECT_EQ(fetch_attribute(buffer, {float64, 2}, {3, 16}, 0), glm::vec4(0.1F, -2.5F, 0, 1));
    const std::uint8_t bytes[] = {255, 0, 51};
    std::memcpy(buffer.data() + 30, bytes, sizeof bytes);
    EXPECT_EQ(fetch_attribute(buffer, {unsigned_byte, 3, true}, {0, 30}, 1), glm::vec4(1, 0, 0.2F, 1));
    EXPECT_EQ(fetch_attribute(buffer, {unsigned_byte, 3, false}, {27, 0}, 1), glm::vec4(255, 0, 51, 1));
    const std::uint32_t most = 0xFFFFFFFF;
    std::memcpy(buffer.data(), &most, sizeof most);
    EXPECT_EQ(fetch_attribute(buffer, {unsigned_int, 1, true}, {0, 0}, 0).x, 1);
}
