#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <umbral/core/png.hpp>
#include <umbral/core/random.hpp>

#include "complaint.hpp"
#include "full_disk.hpp"
#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

namespace umbral {
namespace {

constexpr std::uint64_t seed = 20240611;

Image noise(int width, int height)
{
    Random random(seed);
    Image image(width, height);
    for (auto& pixel : image.cells)
        pixel = {random.below(256), random.below(256), random.below(256), random.below(256)};
    return image;
}

void put(const std::filesystem::path& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

/// OpenCV's pixel (stored blue first) as RGBA.
glm::u8vec4 rgba(const cv::Mat& picture, int x, int y)
{
    const auto bgra = picture.at<cv::Vec4b>(y, x);
    return {bgra[2], bgra[1], bgra[0], bgra[3]};
}

TEST(Png, is_read_by_open_cv_pixel_for_pixel)
{
    SCOPED_TRACE(seed);
    const umbral::test::TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {256, 1}, {1, 300}, {123, 77}}) {
        const Image image = noise(width, height);
        write_png(folder / "a.png", image);
        const cv::Mat read = cv::imread(folder / "a.png", cv::IMREAD_UNCHANGED);
        ASSERT_EQ(read.type(), CV_8UC4);
        ASSERT_EQ(read.cols, width);
        ASSERT_EQ(read.rows, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) ASSERT_EQ(rgba(read, x, y), image.at(x, y)) << x << ' ' << y;
        EXPECT_EQ(read_png(folder / "a.png").cells, image.cells);
        write_png(folder / "a.png", image, Packing::fast);
        EXPECT_EQ(read_png(folder / "a.png").cells, image.cells);
    }
    EXPECT_EQ(folder.count(), 1) << "temporary files were left";
}

TEST(Png, reads_what_open_cv_writes)
{
    const umbral::test::TemporaryFolder folder;
    cv::Mat colour(2, 3, CV_8UC3);
    cv::Mat grey(2, 3, CV_8UC1);
    cv::Mat deep(2, 3, CV_16UC3);
    cv::Mat bits(2, 3, CV_8UC1);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            const int value = 40 * (3 * y + x);
            colour.at<cv::Vec3b>(y, x) =
                cv::Vec3b(static_cast<uchar>(value), static_cast<uchar>(value + 1), static_cast<uchar>(value + 2));
            grey.at<uchar>(y, x) = static_cast<uchar>(value);
            deep.at<cv::Vec3w>(y, x) = cv::Vec3w::all(static_cast<ushort>(257 * value));
            bits.at<uchar>(y, x) = (x + y) % 2 != 0 ? 255 : 0;
        }
    cv::imwrite(folder / "colour.png", colour);
    cv::imwrite(folder / "grey.png", grey);
    cv::imwrite(folder / "deep.png", deep);
    cv::imwrite(folder / "bits.png", bits, {cv::IMWRITE_PNG_BILEVEL, 1});
    const Image read_colour = read_png(folder / "colour.png");
    const Image read_grey = read_png(folder / "grey.png");
    const Image read_deep = read_png(folder / "deep.png");
    const Image read_bits = read_png(folder / "bits.png");
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            const int value = 40 * (3 * y + x);
            EXPECT_EQ(read_colour.at(x, y), glm::u8vec4(value + 2, value + 1, value, 255));
            EXPECT_EQ(read_grey.at(x, y), glm::u8vec4(value, value, value, 255));
            EXPECT_EQ(read_deep.at(x, y), glm::u8vec4(value, value, value, 255));
            EXPECT_EQ(read_bits.at(x, y).r, (x + y) % 2 != 0 ? 255 : 0);
        }
}

TEST(Png, every_truncation_is_refused)
{
    const umbral::test::TemporaryFolder folder;
    write_png(folder / "whole.png", noise(9, 5));
    const std::string whole = umbral::test::read(folder / "whole.png");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        put(folder / "cut.png", whole.substr(0, size));
        const std::string said = complaint([&] { (void)read_png(folder / "cut.png"); });
        ASSERT_NE(said.find("cut.png: "), std::string::npos)
            << "passed with " << size << " of " << whole.size() << " bytes";
        ASSERT_EQ(said.find("empty") != std::string::npos, size == 0);
    }
}

TEST(Png, every_damaged_byte_of_the_pixels_is_refused)
{
    const umbral::test::TemporaryFolder folder;
    write_png(folder / "whole.png", noise(9, 5));
    const std::string whole = umbral::test::read(folder / "whole.png");
    const std::size_t pixels = whole.find("IDAT") + 4;
    const std::size_t length =
        static_cast<unsigned char>(whole[pixels - 5]) + 256U * static_cast<unsigned char>(whole[pixels - 6]);
    for (std::size_t at = pixels; at < pixels + length; ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
        put(folder / "damaged.png", damaged);
        ASSERT_THROW((void)read_png(folder / "damaged.png"), std::runtime_error) << "byte " << at;
    }
}

TEST(Png, huge_dimensions_are_refused_before_memory_is_taken)
{
    const umbral::test::TemporaryFolder folder;
    // 60000 x 60000, grey, from an encoder of our own: IHDR with a right checksum, and no pixels worth the name.
    const std::string signature("\x89PNG\r\n\x1a\n", 8);
    std::string header("IHDR\0\0\xEA\x60\0\0\xEA\x60\x08\0\0\0\0", 17);
    const auto chunk = [](const std::string& content) {
        std::uint32_t sum = 0xFFFFFFFFU;
        for (const char c : content) {
            sum ^= static_cast<unsigned char>(c);
            for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
        }
        const auto number = [](std::uint32_t n) {
            return std::string{static_cast<char>(n >> 24U), static_cast<char>(n >> 16U), static_cast<char>(n >> 8U),
                               static_cast<char>(n)};
        };
        return number(static_cast<std::uint32_t>(content.size() - 4)) + content + number(~sum);
    };
    put(folder / "huge.png", signature + chunk(header) + chunk("IDATx") + chunk("IEND"));
    EXPECT_NE(complaint([&] { (void)read_png(folder / "huge.png"); }).find("60000 x 60000"), std::string::npos);
    header[4] = header[8] = 0x7F;
    put(folder / "huger.png", signature + chunk(header) + chunk("IDATx") + chunk("IEND"));
    EXPECT_NE(complaint([&] { (void)read_png(folder / "huger.png"); }).find("huger.png: "), std::string::npos);
}

TEST(Png, what_is_no_png_is_refused_with_its_name)
{
    const umbral::test::TemporaryFolder folder;
    put(folder / "text.png", "hello, I am a text");
    EXPECT_NE(complaint([&] { (void)read_png(folder / "text.png"); }).find("text.png: not a PNG file"),
              std::string::npos);
    EXPECT_NE(complaint([&] { (void)read_png(folder / "none.png"); }).find("none.png: no such file"),
              std::string::npos);
    EXPECT_NE(complaint([&] { (void)read_png(folder.path()); }).find("not a regular file"), std::string::npos);
    EXPECT_NE(complaint([&] { (void)read_png("/dev/zero"); }).find("not a regular file"), std::string::npos);
    EXPECT_THROW(write_png(folder / "void.png", Image(0, 0)), std::invalid_argument);
    EXPECT_THROW(write_png(folder / "void.png", Image(5, 0)), std::invalid_argument);
}

TEST(Png, a_full_disk_is_an_exception_and_leaves_the_old_file)
{
    const umbral::test::TemporaryFolder folder;
    write_png(folder / "a.png", noise(2, 2));
    const std::string old = umbral::test::read(folder / "a.png");
    {
        const SmallFiles limit(1000);
        const std::string said = complaint([&] { write_png(folder / "a.png", noise(64, 64)); });
        EXPECT_NE(said.find("a.png: cannot write it: File too large"), std::string::npos) << said;
    }
    EXPECT_EQ(umbral::test::read(folder / "a.png"), old);
    EXPECT_EQ(folder.count(), 1);

    const FullDisk outcome = on_full_disk(
        folder, [](const umbral::test::TemporaryFolder& disk) { write_png(disk / "b.png", noise(300, 300)); });
    EXPECT_NE(outcome, FullDisk::failed);
    if (outcome == FullDisk::cannot_mount) GTEST_SKIP() << "a real full disk needs root";
}

// `umbral render --out /dev/null` put a file in the place of the device.
TEST(Png, what_is_no_file_is_not_replaced)
{
    const umbral::test::TemporaryFolder folder;
    const std::filesystem::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_NE(complaint([&] { write_png(pipe, noise(3, 3)); }).find("expected a file to write"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    EXPECT_EQ(folder.count(), 1);
}

TEST(Png, a_missing_folder_is_an_exception_with_the_path)
{
    const umbral::test::TemporaryFolder folder;
    const std::string said = complaint([&] { write_png(folder / "no/such/a.png", noise(2, 2)); });
    EXPECT_NE(said.find("no/such/a.png: "), std::string::npos);
    EXPECT_NE(said.find("No such file or directory"), std::string::npos);
}

}
}
