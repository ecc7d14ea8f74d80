#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <umbral/core/png.hpp>
#include <umbral/core/random.hpp>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// Two files, with the real program.
namespace umbral::test {
namespace {

/// A disc on a shaded ground, moved by `shift` pixels.
Image disc(int shift, int width = 96)
{
    Image image(width, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < width; ++x) {
            const auto ground = static_cast<glm::u8>(40 + y);
            image.at(x, y) = std::hypot(x - 40 - shift, y - 30) < 20 ? glm::u8vec4(220, 120, 30, 255)
                                                                     : glm::u8vec4(ground, ground, 90, 255);
        }
    return image;
}

/// A picture of light with the noise of one exponential sample a pixel times `samples`.
Image noisy(std::uint64_t seed, double light, int samples)
{
    Random random(seed);
    Image image(128, 128);
    for (glm::u8vec4& cell : image.cells) {
        double sum = 0;
        for (int i = 0; i < samples; ++i) sum -= std::log1p(-random.uniform_double());
        const auto code =
            static_cast<glm::u8>(std::lround(255 * std::pow(std::min(1.0, light * sum / samples), 1 / 2.2)));
        cell = {code, code, code, 255};
    }
    return image;
}

class Compare : public testing::Test {
protected:
    void save(const std::string& name, const Image& image) { write_png(folder_ / name, image); }
    [[nodiscard]] Printed compare(const std::string& a, const std::string& b, const std::string& more = "") const
    {
        return umbral("compare '" + (folder_ / a).string() + "' '" + (folder_ / b).string() + "' " + more);
    }
    TemporaryFolder folder_;
};

TEST_F(Compare, pictures_of_which_it_would_take_minutes_are_refused)
{
    save("large.png", Image(4097, 4097));
    const Printed printed = compare("large.png", "large.png");
    EXPECT_EQ(printed.status, 2);
    EXPECT_NE(printed.text.find("compare a part"), std::string::npos) << printed.text;
}

TEST_F(Compare, equal_pictures_agree)
{
    save("a.png", disc(0));
    const Printed printed = compare("a.png", "a.png");
    EXPECT_EQ(printed.status, 0) << printed.text;
    EXPECT_NE(printed.text.find("agree"), std::string::npos);
    EXPECT_NE(printed.text.find("SSIM"), std::string::npos) << printed.text;
}

TEST_F(Compare, a_shifted_picture_does_not_and_says_where)
{
    save("a.png", disc(3));
    save("b.png", disc(0));
    const Printed printed = compare("a.png", "b.png");
    EXPECT_EQ(printed.status, 1) << printed.text;
    for (const char* word : {"do not agree", "SSIM", "PSNR", "RMSE", "differ most in"})
        EXPECT_NE(printed.text.find(word), std::string::npos) << word << printed.text;

    const auto json = nlohmann::json::parse(compare("a.png", "b.png", "--json").text);
    EXPECT_EQ(json.at("format"), "umbral-compare");
    EXPECT_EQ(json.at("agree"), false);
    EXPECT_GT(json.at("metrics").at("rmse").get<double>(), 5);
    EXPECT_LE(json.at("worst").at("x").get<int>() + json.at("worst").at("width").get<int>(), 96);
}

TEST_F(Compare, says_what_was_done_to_a_picture)
{
    save("a.png", disc(0));
    const auto with = [](auto change) {
        Image image = disc(0);
        change(image);
        return image;
    };
    save("bgr.png", with([](Image& image) {
             for (glm::u8vec4& cell : image.cells) std::swap(cell.x, cell.z);
         }));
    save("upside_down.png", with([](Image& image) {
             const Image upright = image;
             for (int y = 0; y < image.height; ++y)
                 for (int x = 0; x < image.width; ++x) image.at(x, y) = upright.at(x, image.height - 1 - y);
         }));
    save("moved.png", disc(3));
    const auto why = [&](const char* name) {
        const auto json = nlohmann::json::parse(compare(name, "a.png", "--json").text);
        return json.at("why").empty() ? std::string() : json.at("why").at(0).at("name").get<std::string>();
    };
    EXPECT_EQ(why("a.png"), "");
    EXPECT_EQ(why("bgr.png"), "red and blue swapped");
    EXPECT_EQ(why("upside_down.png"), "flipped vertically");
    EXPECT_EQ(why("moved.png"), "shifted");
    const Printed printed = compare("bgr.png", "a.png", "--html '" + (folder_ / "page.html").string() + "'");
    EXPECT_NE(printed.text.find("Why: Red and blue are swapped"), std::string::npos) << printed.text;
    EXPECT_NE(read(folder_ / "page.html").find("Red and blue are swapped"), std::string::npos);
}

TEST_F(Compare, other_sizes_do_not_agree_and_say_so)
{
    save("a.png", disc(0));
    save("b.png", disc(0, 100));
    for (const char* rule : {"", "--stochastic"}) {
        const Printed printed = compare("a.png", "b.png", rule);
        EXPECT_EQ(printed.status, 1) << printed.text;
        EXPECT_NE(printed.text.find("96 x 64"), std::string::npos) << printed.text;
        EXPECT_NE(printed.text.find("100 x 64"), std::string::npos) << printed.text;
    }
    EXPECT_EQ(compare("a.png", "b.png", "--html '" + (folder_ / "c.html").string() + "'").status, 1);
    EXPECT_NE(read(folder_ / "c.html").find("The sizes differ"), std::string::npos);
}

TEST_F(Compare, what_is_no_png_is_bad_input)
{
    save("a.png", disc(0));
    folder_.write("empty.png", "");
    folder_.write("text.png", "not a picture");
    folder_.write("cut.png", read(folder_ / "a.png").substr(0, 200));
    std::filesystem::create_directory(folder_ / "folder.png");
    for (const char* bad : {"missing.png", "empty.png", "text.png", "cut.png", "folder.png"}) {
        for (const Printed& printed : {compare("a.png", bad), compare(bad, "a.png", "--stochastic --json")}) {
            EXPECT_EQ(printed.status, 2) << bad << printed.text;
            EXPECT_NE(printed.text.find(bad), std::string::npos) << "the message names the file: " << printed.text;
        }
    }
    EXPECT_EQ(umbral("compare").status, 2);
}

TEST_F(Compare, noise_agrees_by_tiles_only)
{
    save("a.png", noisy(1, 0.2, 16));
    save("b.png", noisy(2, 0.2, 16));
    save("bright.png", noisy(3, 0.2 * 1.05, 16));
    EXPECT_EQ(compare("a.png", "b.png").status, 1) << "pixel by pixel they differ";
    const Printed right = compare("a.png", "b.png", "--stochastic");
    EXPECT_EQ(right.status, 0) << right.text;
    const Printed bright = compare("bright.png", "b.png", "--stochastic");
    EXPECT_EQ(bright.status, 1) << bright.text;
    EXPECT_NE(bright.text.find("too high"), std::string::npos) << bright.text;
}

TEST_F(Compare, the_page_names_both_files_and_holds_the_pictures)
{
    save("a<b>&'.png", disc(3));
    save("b.png", disc(0));
    const std::string page = (folder_ / "page.html").string();
    const Printed printed = umbral("compare \"" + (folder_ / "a<b>&'.png").string() + "\" '" +
                                   (folder_ / "b.png").string() + "' --html '" + page + "'");
    EXPECT_EQ(printed.status, 1) << printed.text;
    const std::string text = read(page);
    EXPECT_NE(text.find("a&lt;b&gt;&amp;&#39;.png"), std::string::npos);
    EXPECT_NE(text.find("data:image/png;base64,"), std::string::npos);
    EXPECT_NE(text.find("do not agree"), std::string::npos);
    EXPECT_EQ(umbral("compare x y --html /nowhere/page.html").status, 2);
}

TEST_F(Compare, help_says_what_the_status_means)
{
    const Printed printed = umbral("compare --help");
    EXPECT_EQ(printed.status, 0);
    for (const char* word : {"Exit status", "--stochastic", "--html", "--json"})
        EXPECT_NE(printed.text.find(word), std::string::npos) << word;
}

}
}
