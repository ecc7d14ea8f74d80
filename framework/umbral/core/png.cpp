#include <fcntl.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <umbral/core/png.hpp>
#include <utility>
#include <vector>

namespace umbral {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int error)
{
    throw std::runtime_error(path.string() + ": " + what + ": " + std::generic_category().message(error));
}

/// A file under a temporary name that vanishes unless `keep_as` succeeds.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::filesystem::path& target) : target_(target)
    {
        // open, not mkstemp: the new file gets the permissions that the user's umask asks for.
        const std::string stem = target.string() + ".tmp-" + std::to_string(::getpid()) + "-";
        for (int attempt = 0; descriptor_ < 0; ++attempt) {
            name_ = stem + std::to_string(attempt);
            descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor_ < 0 && (errno != EEXIST || attempt > 1000))
                fail(target_, "cannot create a temporary file beside it", errno);
        }
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!kept_) ::unlink(name_.c_str());
    }

    void write(std::span<const std::byte> bytes)
    {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail(target_, "cannot write it", errno);
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }

    void keep()
    {
        // Some file systems report a full disk only here.
        if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(target_, "cannot flush it to the disk", errno);
        if (::close(std::exchange(descriptor_, -1)) != 0) fail(target_, "cannot close it", errno);
        if (::rename(name_.c_str(), target_.c_str()) != 0)
            fail(target_, "cannot rename the temporary file to it", errno);
        kept_ = true;
        flush_folder();
    }

private:
    // The rename itself must survive a crash; a file system that cannot flush folders is not an error.
    void flush_folder() const
    {
        const std::filesystem::path folder =
            target_.has_parent_path() ? target_.parent_path() : std::filesystem::path(".");
        const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (descriptor < 0) return;
        (void)::fsync(descriptor);
        ::close(descriptor);
    }

    std::filesystem::path target_;
    std::string name_;
    int descriptor_ = -1;
    bool kept_ = false;
};

/// libpng's simplified interface, freed at the end of the scope.
struct PngImage : png_image {
    PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
    ~PngImage() { png_image_free(this); }
};

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why)
{
    throw std::runtime_error(path.string() + ": " + why);
}

std::vector<unsigned char> read_bytes(const std::filesystem::path& path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) refuse(path, "no such file");
    if (!std::filesystem::is_regular_file(status))
        refuse(path, "expected a PNG file, got something that is not a regular file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) refuse(path, "cannot read it: " + error.message());
    if (size == 0) refuse(path, "expected a PNG file, got an empty file");
    if (size > maximum_png_bytes)
        refuse(path, "expected a PNG file of at most " + std::to_string(maximum_png_bytes) + " bytes, got " +
                         std::to_string(size));

    std::vector<unsigned char> bytes(size);
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
        refuse(path, "cannot read all of its bytes");
    return bytes;
}

std::size_t big_endian(std::span<const unsigned char> bytes)
{
    return (std::size_t{bytes[0]} << 24U) | (std::size_t{bytes[1]} << 16U) | (std::size_t{bytes[2]} << 8U) | bytes[3];
}

/// Follows the chunks to the end mark: libpng's simplified interface does not look for it, so a file cut late would
/// pass.
void expect_whole(const std::filesystem::path& path, std::span<const unsigned char> bytes)
{
    constexpr std::array<unsigned char, 8> signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    const std::size_t compared = std::min(bytes.size(), signature.size());
    if (!std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(compared), signature.begin()))
        refuse(path, "not a PNG file: it does not begin with the PNG signature");

    constexpr std::size_t frame = 12;  // length, type and checksum of a chunk
    for (std::size_t at = signature.size(); bytes.size() >= at + frame;) {
        const std::size_t length = big_endian(bytes.subspan(at));
        if (length > bytes.size() - at - frame) break;
        const auto type = bytes.subspan(at + 4, 4);
        if (std::equal(type.begin(), type.end(), "IEND")) return;
        at += frame + length;
    }
    refuse(path, "truncated PNG file: it ends before its end mark (" + std::to_string(bytes.size()) + " bytes)");
}

}

void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    std::error_code unknown;
    const std::filesystem::file_status status = std::filesystem::status(path, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        refuse(path, "expected a file to write, or a new name; this is a folder or a device");
    TemporaryFile file(path);
    file.write(bytes);
    file.keep();
}

void write_png(const std::filesystem::path& path, const Image& image, Packing packing)
{
    if (image.cells.empty() || image.cells.size() > maximum_png_pixels)
        throw std::invalid_argument(path.string() + ": a PNG holds 1 to " + std::to_string(maximum_png_pixels) +
                                    " pixels, got " + std::to_string(image.width) + " x " +
                                    std::to_string(image.height));
    PngImage png;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGBA;
    if (packing == Packing::fast) png.flags |= PNG_IMAGE_FLAG_FAST;

    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.cells.data(), 0, nullptr) == 0)
        refuse(path, "cannot encode the picture: " + std::string(png.message));
    write_file_atomically(path, std::span(bytes).first(size));
}

Image read_png(const std::filesystem::path& path)
{
    const std::vector<unsigned char> bytes = read_bytes(path);
    expect_whole(path, bytes);

    PngImage png;
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
        refuse(path, "damaged PNG file: " + std::string(png.message));
    if (std::size_t{png.width} * png.height > maximum_png_pixels)
        refuse(path, "expected at most " + std::to_string(maximum_png_pixels) + " pixels, got " +
                         std::to_string(png.width) + " x " + std::to_string(png.height));
    png.format = PNG_FORMAT_RGBA;
    png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;

    Image image(static_cast<int>(png.width), static_cast<int>(png.height));
    if (png_image_finish_read(&png, nullptr, image.cells.data(), 0, nullptr) == 0)
        refuse(path, "damaged PNG file: " + std::string(png.message));
    return image;
}

}
