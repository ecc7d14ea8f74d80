#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/layout.hpp"
#include "report/paint.hpp"

namespace umbral::grader {

/// Collects indented lines; text after a label hangs below itself.
class Block {
public:
    static constexpr int label_width = 10;

    Block(int width, const Paint& paint) : width_(width), paint_(paint) {}

    [[nodiscard]] int room() const { return width_ - 4 - label_width; }
    void line(std::string_view text) { result_ += fmt::format("    {}\n", text); }
    void labelled(std::string_view label, const std::vector<std::string>& lines)
    {
        for (std::size_t i = 0; i < lines.size(); ++i)
            line(paint_(Tone::quiet, pad(i == 0 ? label : "", label_width)) + lines[i]);
    }
    void sentence(std::string_view label, std::string_view text) { labelled(label, wrap(paint_.safe(text), room())); }
    void blank() { result_ += '\n'; }
    [[nodiscard]] std::string take() { return std::move(result_); }

private:
    int width_;
    const Paint& paint_;
    std::string result_;
};

}
